// Prepares a thread for the real-time cycle.
#include "symplant/exec/real_time.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>
#include <system_error>

#include "symplant/exec/memory_map.hpp"

namespace symplant::exec {
namespace {

constexpr std::size_t kStack = std::size_t{256} * 1024;  ///< more than a cycle uses
constexpr std::size_t kSpare = std::size_t{32} * 1024;   ///< of the stack, for calls below touch_stack()
constexpr std::size_t kPage = 4096;
constexpr std::uint64_t kMegabyte = 1024 * 1024;

std::string reason(int error) { return std::generic_category().message(error); }

/// Bytes of the thread's stack that are free below `here`; 0 if unknown.
std::size_t free_stack(const void* here) noexcept {
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return 0;
  void* lowest = nullptr;
  std::size_t size = 0;
  const bool known = pthread_attr_getstack(&attributes, &lowest, &size) == 0;
  pthread_attr_destroy(&attributes);
  return known ? static_cast<std::size_t>(static_cast<const char*>(here) - static_cast<const char*>(lowest)) : 0;
}

/// Touches `bytes` of the stack, one page per call, from the top downwards. They must be free: `ulimit -s` may leave
/// less than kStack.
__attribute__((noinline)) void touch_stack(std::size_t bytes) noexcept {
  std::array<volatile std::byte, kPage> page;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  page[0] = std::byte{};
  if (bytes > kPage) touch_stack(bytes - kPage);
  page[kPage - 1] = std::byte{};  // after the call, so that its frame stays
}

std::optional<Refusal> take_priority(int priority) {
  sched_param wanted{};
  wanted.sched_priority = priority;
  if (sched_setscheduler(0, SCHED_FIFO, &wanted) == 0) return std::nullopt;
  const std::string number = std::to_string(priority);
  return Refusal{"priority", "`--priority " + number + "` is refused (" + reason(errno) +
                                 "), other programs can delay the cycle: allow it with `ulimit -r " + number +
                                 "`, with LimitRTPRIO=" + number +
                                 " in a systemd unit, or with the capability CAP_SYS_NICE"};
}

/// "0 to 3, 6".
std::string text_of(const cpu_set_t& cpus) {
  std::string text;
  for (std::size_t first = 0; first < CPU_SETSIZE; ++first) {
    if (!CPU_ISSET(first, &cpus)) continue;
    std::size_t last = first;
    while (last + 1 < CPU_SETSIZE && CPU_ISSET(last + 1, &cpus)) ++last;
    text += (text.empty() ? "" : ", ") + std::to_string(first);
    if (last > first) text += " to " + std::to_string(last);
    first = last;
  }
  return text;
}

std::optional<Refusal> stay_on(std::size_t cpu) {
  const std::string option = "`--cpu " + std::to_string(cpu) + "` is refused";
  const char* const meaning = ", the cycle may move between processors: ";
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  sched_getaffinity(0, sizeof allowed, &allowed);
  if (cpu >= CPU_SETSIZE || !CPU_ISSET(cpu, &allowed)) {
    return Refusal{"cpu", option + " (it does not exist, or this process may not use it)" + meaning + "use one of " +
                              text_of(allowed)};
  }
  cpu_set_t wanted;
  CPU_ZERO(&wanted);
  CPU_SET(cpu, &wanted);
  if (sched_setaffinity(0, sizeof wanted, &wanted) == 0) return std::nullopt;
  return Refusal{"cpu", option + " (" + reason(errno) + ")" + meaning + "use another one of " + text_of(allowed)};
}

std::string megabytes(std::uint64_t bytes) { return std::to_string((bytes + kMegabyte - 1) / kMegabyte) + " MB"; }

/// Bytes of all mappings, which the limit counts.
std::uint64_t mapped_memory() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

std::optional<Refusal> lock_memory() {
#ifdef MCL_ONFAULT
  constexpr int kWhat = MCL_CURRENT | MCL_ONFAULT;  // not MCL_FUTURE: it makes later allocations fail at the limit
#else
  constexpr int kWhat = MCL_CURRENT;
#endif
  if (mlockall(kWhat) == 0) return std::nullopt;
  const int error = errno;
  rlimit limit{};
  std::string why = reason(error);
  if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    why = megabytes(mapped_memory()) + " are mapped, " + megabytes(limit.rlim_cur) + " may be locked";
  }
  return Refusal{"lock-memory",
                 "`--lock-memory` is refused (" + why +
                     "), the cycle may have to wait for memory that was swapped out: allow it with `ulimit -l "
                     "unlimited`, with LimitMEMLOCK=infinity in a systemd unit, or with the capability CAP_IPC_LOCK"};
}

std::optional<Refusal> stay_awake(std::unique_ptr<std::FILE, CloseFile>& awake) {
  constexpr const char* kDevice = "/dev/cpu_dma_latency";
  constexpr std::int32_t kNone = 0;
  std::unique_ptr<std::FILE, CloseFile> device(std::fopen(kDevice, "wb"));
  if (device && std::fwrite(&kNone, sizeof kNone, 1, device.get()) == 1 && std::fflush(device.get()) == 0) {
    awake = std::move(device);
    return std::nullopt;
  }
  return Refusal{"stay-awake", "`--stay-awake` is refused (" + reason(errno) +
                                   "), an idle processor may wake late for the cycle: allow the program to write " +
                                   kDevice + " with a udev rule for its group, or run it as root"};
}

}  // namespace

RealTimeSetup set_up_real_time(const RealTimeOptions& options) {
  RealTimeSetup setup;
  const auto note = [&](std::optional<Refusal> refusal) {
    if (refusal) setup.refused.push_back(std::move(*refusal));
  };
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
  const char here = 0;
  const std::size_t left = free_stack(&here);
  if (left > kSpare) touch_stack(std::min(left - kSpare, kStack));
  populate_memory();
  if (options.lock_memory) note(lock_memory());
  if (options.cpu) note(stay_on(static_cast<std::size_t>(*options.cpu)));
  if (options.priority) note(take_priority(*options.priority));
  if (options.stay_awake) note(stay_awake(setup.awake));
  return setup;
}

}  // namespace symplant::exec
