// The clock that paces the cycle: a parameter, so that tests hand in one of their own.
#pragma once

#include "symplant/tables/time.hpp"

namespace symplant::exec {

/// A clock that never goes back. Its zero is anywhere.
class Clock {
 public:
  Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  virtual ~Clock() = default;

  virtual tables::Time now() noexcept = 0;
  /// Sleeps until `time`. May come back earlier (a signal, say), so callers look at the clock again.
  virtual void sleep_until(tables::Time time) noexcept = 0;
};

/// CLOCK_MONOTONIC, whatever happens to the time of day. Sleeps on absolute times, so that no delay adds up.
class MonotonicClock final : public Clock {
 public:
  tables::Time now() noexcept override;
  void sleep_until(tables::Time time) noexcept override;
};

}  // namespace symplant::exec
