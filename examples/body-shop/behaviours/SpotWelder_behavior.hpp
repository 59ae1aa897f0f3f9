// The behavior of the weld controls of the body shop: spots are counted, and each has a current.
#pragma once

#include <cstdint>

#include "types_gen.hpp"

namespace body_shop {

/// With power on, a spot takes 400 ms while the robot works. Its current is 8.50 to 8.90 kA, from --seed. The counter
/// is reset when the caps are dressed with power on.
class SpotWelder : public WELDER {
 public:
  using hooks = Hooks<Hook::entered, Hook::left, Hook::woken>;

  static void entered(View& view, State state) noexcept {
    if (state == State::ON) view.wake_after(kSpot);
  }

  static void left(View& view, State) noexcept { view.wake_at(symplant::tables::kNever); }

  static void woken(View& view) noexcept {
    view.wake_after(kSpot);
    if (view.input(Input::dressed)) view.set_value<Value::I_SPOTS>(0);
    if (!view.input(Input::welds)) return;
    view.set_value<Value::I_CURRENT>(static_cast<std::int16_t>(850 + view.draw() % 41));
    view.set_value<Value::I_SPOTS>(static_cast<std::uint16_t>(view.value<Value::I_SPOTS>() + 1));
  }

 private:
  static constexpr Time kSpot = 400 * kMillisecond;
};

}  // namespace body_shop
