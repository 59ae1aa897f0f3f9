// The vehicle of the cell: it leaves P2 only on a command of 200 ms, and then drives slowly; I_P1 stays on until it is
// at P2.
#pragma once

#include "types_gen.hpp"

namespace own_functions {

/// Functions that this class defines replace those of the generated class, while compiling.
class MyAgv : public AGV {
 public:
  static constexpr Dt dt_back{.after = 200 * kMillisecond, .takes = 3 * kSecond};

  /// From P2 it returns slowly; otherwise as the generated class says.
  static constexpr Moves d_ext(State a, Operation x) noexcept {
    if (a == State::P2 && x == Operation::O_P1) return go(State::P1, dt_back);
    return AGV::d_ext(a, x);
  }

  /// I_P1 stays on until the vehicle arrives at P2.
  static constexpr Events l_leave(State x) noexcept { return x == State::P1 ? Events{} : AGV::l_leave(x); }
  static constexpr Events l_enter(State x) noexcept {
    return x == State::P2 ? on(Event::I_P2) | off(Event::I_P1) : AGV::l_enter(x);
  }
};

}  // namespace own_functions
