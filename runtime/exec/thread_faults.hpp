// Page faults and preemptions of a thread: what a cycle can suffer without a call of its own.
#pragma once

#include <cstdint>

namespace symplant::exec {

struct ThreadFaults {
  std::uint64_t minor = 0;      ///< pages that were not there yet, and came from memory
  std::uint64_t major = 0;      ///< pages that came from disk
  std::uint64_t preempted = 0;  ///< times that the processor was taken away

  std::uint64_t pages() const noexcept { return minor + major; }
  ThreadFaults operator-(const ThreadFaults& before) const noexcept {
    return {minor - before.minor, major - before.major, preempted - before.preempted};
  }
  ThreadFaults& operator+=(const ThreadFaults& more) noexcept {
    minor += more.minor;
    major += more.major;
    preempted += more.preempted;
    return *this;
  }
};

/// Of the calling thread since it began; a system call. All 0 where the system does not tell.
ThreadFaults thread_faults() noexcept;

}  // namespace symplant::exec
