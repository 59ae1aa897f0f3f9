// Reads page faults and preemptions as counted by the kernel.
#include "symplant/exec/thread_faults.hpp"

#include <sys/resource.h>

namespace symplant::exec {

ThreadFaults thread_faults() noexcept {
#ifdef RUSAGE_THREAD
  rusage usage{};
  if (getrusage(RUSAGE_THREAD, &usage) != 0) return {};
  return {static_cast<std::uint64_t>(usage.ru_minflt), static_cast<std::uint64_t>(usage.ru_majflt),
          static_cast<std::uint64_t>(usage.ru_nivcsw)};
#else
  return {};
#endif
}

}  // namespace symplant::exec
