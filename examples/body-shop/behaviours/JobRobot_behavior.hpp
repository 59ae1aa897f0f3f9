// The behavior of the robots of the body shop: a robot reports the program that it runs.
#pragma once

#include "types_gen.hpp"

namespace body_shop {

/// The program is read when the job begins, and is reported until the robot is at home.
class JobRobot : public ROBOT {
 public:
  using hooks = Hooks<Hook::entered>;

  static void entered(View& view, State state) noexcept {
    if (state == State::JOB2) view.set_value<Value::I_PROG>(view.value<Value::O_PROG>());
    if (state == State::HOME1) view.set_value<Value::I_PROG>(0);
  }
};

}  // namespace body_shop
