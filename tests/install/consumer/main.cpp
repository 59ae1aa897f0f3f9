// A user program around a generated plant: commands the ram down and waits until it arrives.
#include <cstdio>
#include <memory>

#include "press/plant_gen.hpp"

namespace {

int failures = 0;

void expect(bool holds, const char* what) {
  std::printf("%s: %s\n", holds ? "ok" : "FAILED", what);
  if (!holds) ++failures;
}
}  // namespace

int main() {
  using press_line::RAM;
  using press_line::Symbol;
  using symplant::tables::kSecond;

  const std::unique_ptr<press_line::Plant> plant = press_line::make_plant();
  auto ram = plant->press().ram();

  plant->advance_to(0);
  expect(ram.is_in(RAM::State::UP) && plant->is_on(Symbol::HALL2_PRESS_RAM_I_UP), "the ram starts up");

  ram.command(RAM::Operation::O_DOWN);
  plant->advance_to(kSecond);
  expect(ram.moving_to() == RAM::State::DOWN && !ram.event(RAM::Event::I_UP), "the ram leaves");

  plant->advance_to(2 * kSecond);
  expect(ram.is_in(RAM::State::DOWN) && ram.event(RAM::Event::I_DOWN), "the ram comes down");
  expect(RAM::d_ext(RAM::State::UP, RAM::Operation::O_DOWN).lead_to(RAM::State::DOWN), "as its class says");
  return failures == 0 ? 0 : 1;
}
