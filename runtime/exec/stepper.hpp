// Who brings the plant on to a cycle's time in place of the plant itself: a scenario, say.
#pragma once

#include "symplant/tables/time.hpp"

namespace symplant::exec {

/// Called by the thread of the cycle, behind the links' reading and before their writing; bounded and noexcept.
class Stepper {
 public:
  /// Runs the plant to `time`, its instant included.
  virtual void advance_to(tables::Time time) noexcept = 0;
  /// Whether it has nothing more to do, so that the run may end.
  virtual bool over() const noexcept = 0;

 protected:
  ~Stepper() = default;
};

}  // namespace symplant::exec
