// Page faults and preemptions of a thread: delays of a cycle that no call of its code causes.
#pragma once

#include <cstdint>

namespace symplant::exec {

struct ThreadFaults {
  std::uint64_t minor = 0;      ///< page faults resolved without the disk
  std::uint64_t major = 0;      ///< page faults that read from disk
  std::uint64_t preempted = 0;  ///< involuntary context switches

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

/// The counts of the calling thread since it started; a system call. All 0 if the system does not provide them.
ThreadFaults thread_faults() noexcept;

}  // namespace symplant::exec
