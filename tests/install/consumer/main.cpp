// A user program around a generated plant: commands the ram down and waits until it arrives.
#include <cstdint>
#include <cstdio>
#include <memory>

#include "press/devices_gen.hpp"
#include "press/plant_gen.hpp"
#include "press/types_gen.hpp"
#include "symplant/plant/plant.hpp"

namespace {

int failures = 0;

void expect(bool holds, const char* what) {
  std::printf("%s: %s\n", holds ? "ok" : "FAILED", what);
  if (!holds) ++failures;
}

std::uint32_t bit_of(const symplant::plant::Plant& plant, press_line::Symbol symbol) {
  return plant.tables().symbols[static_cast<std::size_t>(symbol)].index;
}

}  // namespace

int main() {
  using press_line::Symbol;
  using symplant::tables::kSecond;
  using State = press_line::RAM::State;

  const std::unique_ptr<press_line::Plant> owned = press_line::make_plant();
  symplant::plant::Plant& plant = *owned;
  const auto ram = static_cast<std::uint32_t>(press_line::Device::kHALL2_PRESS_RAM);
  const auto state = [&] { return static_cast<State>(plant.unit(ram).state); };

  plant.advance_to(0);
  expect(state() == State::kUP && plant.event(bit_of(plant, Symbol::kHALL2_PRESS_RAM_I_UP)), "the ram starts up");

  plant.set_operation(bit_of(plant, Symbol::kHALL2_PRESS_RAM_O_DOWN), true);
  plant.advance_to(kSecond);
  expect(plant.unit(ram).moving && !plant.event(bit_of(plant, Symbol::kHALL2_PRESS_RAM_I_UP)), "the ram leaves");

  plant.advance_to(2 * kSecond);
  expect(state() == State::kDOWN && plant.event(bit_of(plant, Symbol::kHALL2_PRESS_RAM_I_DOWN)), "the ram comes down");
  expect(State::kDOWN == press_line::RAM::d_ext(State::kUP, press_line::RAM::Operation::kDOWN), "as its class says");
  return failures == 0 ? 0 : 1;
}
