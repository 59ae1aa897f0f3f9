// An interface to advance the plant to a cycle's time, for example with a scenario, or by an operator.
#pragma once

#include "symplant/tables/time.hpp"

namespace symplant::exec {

/// The cycle's thread calls it after the links' reads and before their writes. The calls must be bounded.
class Stepper {
 public:
  /// Advances the plant to `time`, including the instant at `time`. It may set the plant back to an earlier time
  /// instead: the next cycle goes on from there.
  virtual void advance_to(tables::Time time) noexcept = 0;
  /// As advance_to(), for a part of a cycle; the rest of the cycle follows.
  virtual void advance_within(tables::Time time) noexcept { advance_to(time); }
  /// Whether the stepper stops plant time. Links may stop it independently (Exchange::freezes_plant()).
  virtual bool frozen() const noexcept { return false; }
  /// Called instead of advance_to() in a cycle in which plant time does not run. Acts from outside, such as those of an
  /// operator, may run further instants at the plant's time.
  virtual void hold() noexcept {}
  /// Whether the stepper has nothing left to do, so that the run may end.
  virtual bool over() const noexcept = 0;
  /// Whether the stepper cannot go on, so that the run must end.
  virtual bool failed() const noexcept { return false; }

 protected:
  ~Stepper() = default;
};

}  // namespace symplant::exec
