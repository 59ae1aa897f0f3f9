// The generated classes match the paper, and the factory and constants are available to user code.
#include <type_traits>

#include "compiled_cylinder/types_gen.hpp"
#include "compiled_excell/devices_gen.hpp"
#include "compiled_excell/plant_gen.hpp"
#include "compiled_excell/types_gen.hpp"
#include "compiled_mixed/types_gen.hpp"
#include "support/catch.hpp"
#include "support/worked_example.hpp"

namespace symplant::test {
namespace {

// The paper's AGV: I = {P2, P1}, O = {P1, P2}, S = {P1, P2}.
using excell::AGV;
static_assert(AGV::kI.size() == 2 && AGV::kO.size() == 2 && AGV::kS.size() == 2);
static_assert(AGV::d_ext(AGV::State::kP1, AGV::Operation::kP2) == AGV::State::kP2);
static_assert(AGV::d_ext(AGV::State::kP2, AGV::Operation::kP1) == AGV::State::kP1);
static_assert(AGV::d_ext(AGV::State::kP2, AGV::Operation::kP2) == AGV::State::kP2, "it leads nowhere from there");
static_assert(AGV::d_int(AGV::State::kP1) == AGV::State::kP1, "it stays");
static_assert(AGV::l_enter(AGV::State::kP1).on == 1 && AGV::l_enter(AGV::State::kP1).off == 0);
static_assert(AGV::l_leave(AGV::State::kP2).on == 0 && AGV::l_leave(AGV::State::kP2).off == 2);

// A machine with automatic transitions.
using mixed::ROBOT;
static_assert(ROBOT::d_int(ROBOT::State::kWORK2) == ROBOT::State::kDONE3);
static_assert(ROBOT::d_int(ROBOT::State::kDONE3) == ROBOT::State::kIDLE1);
static_assert(ROBOT::d_int(ROBOT::State::kIDLE1) == ROBOT::State::kIDLE1);

// A single solenoid rests where no command drives it.
static_assert(cylinder::CYL::row().actuation == tables::Actuation::spring);
static_assert(cylinder::CYL::row().rest == static_cast<std::uint8_t>(cylinder::CYL::State::kRET));

TEST_CASE("Without a description no device is disabled") {
  const auto agv = static_cast<std::uint32_t>(excell::Device::kEXLINE_MB_AGV);
  for (const AGV::State state : AGV::kS) CHECK(AGV::l_disable(agv, state).empty());
}

TEST_CASE("The factory makes a plant whose devices and symbols are found by name") {
  const auto plant = excell::make_plant();
  const auto device = static_cast<std::uint32_t>(excell::Device::kEXLINE_MB_AGV);
  const auto symbol = static_cast<std::uint32_t>(excell::Symbol::kEXLINE_MB_AGV_O_P2);
  plant->advance_to(0);
  CHECK(static_cast<AGV::State>(plant->unit(device).state) == AGV::State::kP1);
  plant->set_operation(plant->tables().symbols[symbol].index, true);
  plant->advance_to(tables::kSecond);
  plant->advance_to(2 * tables::kSecond);
  CHECK(static_cast<AGV::State>(plant->unit(device).state) == AGV::State::kP2);
}

TEST_CASE("The generated plant matches the worked example exactly, and again after a reset") {
  const auto plant = excell::make_plant();
  check_worked_example(*plant);
  plant->reset();
  check_worked_example(*plant);
}

}  // namespace
}  // namespace symplant::test
