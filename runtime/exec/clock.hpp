// The clock that paces the cycle: an interface, so that tests can replace it.
#pragma once

#include "symplant/tables/time.hpp"

namespace symplant::exec {

/// A clock that never goes back, in ns. Its zero is arbitrary.
class Clock {
 public:
  Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  virtual ~Clock() = default;

  virtual tables::Time now() noexcept = 0;
  /// Sleeps until `time`. May return earlier (for example after a signal), so callers must check now().
  virtual void sleep_until(tables::Time time) noexcept = 0;
};

/// CLOCK_MONOTONIC: changes of the time of day have no effect. Sleeps until absolute times, so delays do not add up.
class MonotonicClock final : public Clock {
 public:
  tables::Time now() noexcept override;
  void sleep_until(tables::Time time) noexcept override;
};

}  // namespace symplant::exec
