// The behavior of the cameras of the body shop: they judge each picture.
#pragma once

#include "types_gen.hpp"

namespace body_shop {

/// A verdict is 1, good, or 2, bad: one picture of 20, from --seed.
class JudgingCamera : public CAMERA {
 public:
  using hooks = Hooks<Hook::entered>;

  static void entered(View& view, State state) noexcept {
    if (state == State::READY1) view.set_value<Value::I_RESULT>(view.draw() % 20 == 0 ? 2 : 1);
  }
};

}  // namespace body_shop
