// Every mapping of the process, populated.
#include "symplant/exec/memory_map.hpp"

#include <sys/mman.h>

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

namespace symplant::exec {
namespace {

// As Linux 5.14 numbers them; older headers have no names for them.
constexpr int kPopulateRead = 22;
constexpr int kPopulateWrite = 23;

constexpr std::uintptr_t kLargest = std::uintptr_t{256} << 20;
constexpr std::uintptr_t kLargestFence = std::uintptr_t{64} << 10;

struct Mapping {
  std::uintptr_t begin = 0;
  std::uintptr_t end = 0;
  bool readable = false;
  bool writable = false;
  bool own = false;  ///< not shared with other processes
};

bool parse(const std::string& line, Mapping& mapping) {
  unsigned long begin = 0;
  unsigned long end = 0;
  char rights[5] = {};
  if (std::sscanf(line.c_str(), "%lx-%lx %4s", &begin, &end, rights) != 3) return false;
  mapping = {begin, end, rights[0] == 'r', rights[1] == 'w', rights[3] == 'p'};
  return true;
}

/// A thread's stack lies right above a small piece that nobody may touch.
bool is_stack(const Mapping& mapping, const Mapping& below) {
  return mapping.writable && below.end == mapping.begin && !below.readable && !below.writable &&
         below.end - below.begin <= kLargestFence;
}

}  // namespace

void populate_memory() {
  std::ifstream maps("/proc/self/maps");
  Mapping below;
  Mapping mapping;
  for (std::string line; std::getline(maps, line); below = mapping) {
    if (!parse(line, mapping)) continue;
    const bool special = line.find("[v") != std::string::npos;  // the kernel's own
    if (special || !mapping.readable || !mapping.own || is_stack(mapping, below)) continue;
    if (mapping.end - mapping.begin > kLargest) continue;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the kernel tells addresses as numbers
    madvise(reinterpret_cast<void*>(mapping.begin), mapping.end - mapping.begin,
            mapping.writable ? kPopulateWrite : kPopulateRead);
  }
}

}  // namespace symplant::exec
