// The behavior of the sealers of the body shop: they report their pressure.
#pragma once

#include <cstdint>

#include "types_gen.hpp"

namespace body_shop {

/// The pressure in bar/10 is that of the flow that the PLC wants, 1 bar for each 10 ml/min, at most 250 bar; 0 when
/// off.
class BodySealer : public SEALER {
 public:
  using hooks = Hooks<Hook::entered>;

  static void entered(View& view, State state) noexcept {
    view.set_value<Value::I_PRESSURE>(state == State::ON ? pressure(view.value<Value::O_FLOW>()) : std::int16_t{0});
  }

 private:
  static constexpr std::int16_t pressure(std::int16_t flow) noexcept {
    return flow < 0 ? std::int16_t{0} : flow > 2500 ? std::int16_t{2500} : flow;
  }
};

}  // namespace body_shop
