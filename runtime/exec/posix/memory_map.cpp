// Populates every memory mapping of the process.
#include "symplant/exec/memory_map.hpp"

#include <pthread.h>
#include <sys/mman.h>

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

namespace symplant::exec {
namespace {

// The values of Linux 5.14; older headers do not define them.
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

/// A thread's stack is directly above a small mapping without access rights (the guard page). The kernel shows it and
/// memory directly after it as one mapping.
bool begins_with_stack(const Mapping& mapping, const Mapping& below) {
  return mapping.writable && below.end == mapping.begin && !below.readable && !below.writable &&
         below.end - below.begin <= kLargestFence;
}

std::uintptr_t stack_size() {
  pthread_attr_t defaults;
  std::size_t size = 0;
  if (pthread_getattr_default_np(&defaults) != 0) return kLargest;
  pthread_attr_getstacksize(&defaults, &size);
  pthread_attr_destroy(&defaults);
  return size;
}

}  // namespace

void populate_memory() {
  const std::uintptr_t stack = stack_size();
  std::ifstream maps("/proc/self/maps");
  Mapping below;
  Mapping mapping;
  for (std::string line; std::getline(maps, line); below = mapping) {
    if (!parse(line, mapping)) continue;
    const bool special = line.find("[v") != std::string::npos;  // mappings of the kernel
    if (special || !mapping.readable || !mapping.own) continue;
    const std::uintptr_t begin = begins_with_stack(mapping, below) ? mapping.begin + stack : mapping.begin;
    if (begin >= mapping.end || mapping.end - begin > kLargest) continue;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the kernel gives addresses as numbers
    madvise(reinterpret_cast<void*>(begin), mapping.end - begin, mapping.writable ? kPopulateWrite : kPopulateRead);
  }
}

}  // namespace symplant::exec
