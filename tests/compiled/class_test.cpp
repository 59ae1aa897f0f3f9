// The generated classes match the paper, and the factory and constants are available to user code.
#include <stdexcept>

#include "compiled_cylinder/types_gen.hpp"
#include "compiled_excell/plant_gen.hpp"
#include "compiled_mixed/plant_gen.hpp"
#include "support/catch.hpp"
#include "support/worked_example.hpp"

namespace symplant::test {
namespace {

// The paper's AGV: I = {P2, P1}, O = {P1, P2}, S = {P1, P2}.
using excell::AGV;
static_assert(AGV::kI.size() == 2 && AGV::kO.size() == 2 && AGV::kS.size() == 2);
static_assert(AGV::d_ext(AGV::State::P1, AGV::Operation::O_P2).lead_to(AGV::State::P2));
static_assert(AGV::d_ext(AGV::State::P2, AGV::Operation::O_P1).lead_to(AGV::State::P1));
static_assert(AGV::d_ext(AGV::State::P2, AGV::Operation::O_P2).size() == 0, "it leads nowhere from there");
static_assert(AGV::d_int(AGV::State::P1).size() == 0, "it stays");
static_assert(AGV::l_enter(AGV::State::P1).on == 1 && AGV::l_enter(AGV::State::P1).off == 0);
static_assert(AGV::l_leave(AGV::State::P2).on == 0 && AGV::l_leave(AGV::State::P2).off == 2);

// A machine with automatic transitions.
using mixed::ROBOT;
static_assert(ROBOT::d_int(ROBOT::State::WORK2).lead_to(ROBOT::State::DONE3));
static_assert(ROBOT::d_int(ROBOT::State::DONE3).lead_to(ROBOT::State::IDLE1));
static_assert(ROBOT::d_int(ROBOT::State::IDLE1).size() == 0);

// A single solenoid rests where no command drives it.
static_assert(cylinder::CYL::kActuation == tables::Actuation::spring);
static_assert(cylinder::CYL::kRest == cylinder::CYL::State::RET);

TEST_CASE("Without a description no device is disabled") {
  excell::Plant plant;
  for (const AGV::State state : AGV::kS) CHECK(AGV::l_disable(plant.agv().index(), state).empty());
}

TEST_CASE("A device is commanded and read by its class's names") {
  excell::Plant plant;
  auto agv = plant.mb().agv();
  plant.advance_to(0);
  CHECK(agv.is_in(AGV::State::P1));
  CHECK(agv.event(AGV::Event::I_P1));
  agv.command(AGV::Operation::O_P2);
  plant.advance_to(tables::kSecond);
  CHECK(agv.state() == AGV::State::P1);
  CHECK(agv.moving_to() == AGV::State::P2);
  CHECK_FALSE(agv.event(AGV::Event::I_P1));
  plant.advance_to(3 * tables::kSecond / 2);
  CHECK(agv.progress() == 0.5);
  agv.command(AGV::Operation::O_P2, false);
  plant.advance_to(2 * tables::kSecond);
  CHECK(agv.is_in(AGV::State::P2));
  CHECK_FALSE(agv.moving_to());
  CHECK_FALSE(agv.operation(AGV::Operation::O_P2));
  agv.put(AGV::State::P1);
  plant.advance_to(2 * tables::kSecond);
  CHECK(plant.exline().mb().agv().is_in(AGV::State::P1));
}

TEST_CASE("Symbols are set, forced and read by their names") {
  excell::Plant plant;
  using excell::Symbol;
  plant.advance_to(0);
  plant.set(Symbol::EXLINE_MB_AGV_O_P2, true);
  plant.advance_to(tables::kSecond);
  CHECK(plant.is_on(Symbol::EXLINE_MB_AGV_O_P2));
  CHECK_FALSE(plant.is_on(Symbol::EXLINE_MB_AGV_I_P1));
  CHECK_THROWS_AS(plant.set(Symbol::EXLINE_MB_AGV_I_P1, true), std::logic_error);
  plant.force(Symbol::EXLINE_MB_AGV_I_P1, true);
  plant.advance_to(tables::kSecond);
  CHECK(plant.is_on(Symbol::EXLINE_MB_AGV_I_P1));
  plant.release(Symbol::EXLINE_MB_AGV_I_P1);
  plant.advance_to(tables::kSecond);
  CHECK_FALSE(plant.is_on(Symbol::EXLINE_MB_AGV_I_P1));
}

TEST_CASE("Numbered devices of a process are found by their numbers") {
  mixed::Plant plant;
  plant.advance_to(0);
  const auto clamps = plant.l1().s10().clamp();
  REQUIRE(clamps.size() == 2);
  CHECK(clamps[2].moving_to() == mixed::CLAMP::State::OPEN);  // it starts closed, and falls open
  CHECK(clamps[1].index() == plant.clamp1().index());
  CHECK_THROWS_AS(clamps[3], std::out_of_range);
  for (auto clamp : clamps) clamp.command(mixed::CLAMP::Operation::O_CLOSE);
  plant.advance_to(tables::kSecond);
  plant.advance_to(2 * tables::kSecond);
  for (const auto clamp : clamps) CHECK(clamp.is_in(mixed::CLAMP::State::CLOSE));
}

TEST_CASE("Numbers are set and read in the type of their symbol") {
  mixed::Plant plant;
  using mixed::Symbol;
  plant.advance_to(0);
  CHECK(plant.value(Symbol::L1_S30_SCALE_O_TARE) == 12);
  CHECK(plant.value<int>(Symbol::L1_S30_SCALE_I_NET) == -3);
  CHECK(plant.value(Symbol::L1_S30_SCALE_I_GROSS) == 1.5);
  plant.set(Symbol::L1_S30_SCALE_O_TARE, -7);
  plant.set(Symbol::L1_S30_SCALE_I_GROSS, 2.1);
  plant.advance_to(1);
  CHECK(plant.value<int>(Symbol::L1_S30_SCALE_O_TARE) == -7);
  CHECK(plant.value<float>(Symbol::L1_S30_SCALE_I_GROSS) == 2.1F);
}

TEST_CASE("The generated plant matches the worked example exactly, and again after a reset") {
  const auto plant = excell::make_plant();
  check_worked_example(*plant);
  plant->reset();
  check_worked_example(*plant);
}

}  // namespace
}  // namespace symplant::test
