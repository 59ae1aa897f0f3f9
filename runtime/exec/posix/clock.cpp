// Reads CLOCK_MONOTONIC in nanoseconds.
#include "symplant/exec/clock.hpp"

#include <ctime>

#include "symplant/exec/guard/guard.hpp"

namespace symplant::exec {

tables::Time MonotonicClock::now() noexcept {
  const Unguarded allowed;  // a system call if the kernel has no vDSO
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return tables::Time{time.tv_sec} * tables::kSecond + tables::Time{time.tv_nsec};
}

void MonotonicClock::sleep_until(tables::Time time) noexcept {
  const Unguarded allowed;
  timespec until{};
  until.tv_sec = static_cast<time_t>(time / tables::kSecond);
  until.tv_nsec = static_cast<long>(time % tables::kSecond);
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
}

}  // namespace symplant::exec
