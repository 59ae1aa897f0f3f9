// An interface to advance the plant to a cycle's time, for example with a scenario.
#pragma once

#include "symplant/tables/time.hpp"

namespace symplant::exec {

/// The cycle's thread calls it after the links' reads and before their writes. The calls must be bounded.
class Stepper {
 public:
  /// Advances the plant to `time`, including the instant at `time`.
  virtual void advance_to(tables::Time time) noexcept = 0;
  /// Whether it has nothing left to do, so that the run may end.
  virtual bool over() const noexcept = 0;

 protected:
  ~Stepper() = default;
};

}  // namespace symplant::exec
