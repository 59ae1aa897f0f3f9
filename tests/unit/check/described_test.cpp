// Findings on descriptions: states, conditions, requirements.
#include "check_support.hpp"

namespace symplant::test {
namespace {

// Unreachable states.

TEST_CASE("Commanded and automatic transitions and a spring return reach a state") {
  description::DeviceDescription d = device();
  d.states = {"MID", "END"};
  d.only = true;
  d.transitions = {transition("P1", "P2"), by_itself("P2", "MID", "L_P_E.A2"), by_itself("MID", "END"),
                   transition("END", "P1")};
  CHECK(reported(analyse_described(two_devices(), describing({d})), "unreachable-state") == "");
  description::DeviceDescription s = device();
  s.only = true;
  s.actuation = tables::Actuation::spring;
  s.rest = "P1";
  s.initial = "P2";
  CHECK(reported(analyse_described(two_devices(), describing({s})), "unreachable-state") == "");
}

TEST_CASE("An unreachable state is reported where the description adds it, or at `only`") {
  description::DeviceDescription d = device();
  d.states = {"MID"};
  d.only = true;
  d.transitions = {transition("MID", "P1"), transition("P2", "P1")};
  CHECK(
      reported(analyse_described(two_devices(), describing({d})), "unreachable-state") ==
      "/devices/L_P_D/only: nothing leads to `P2` of `L_P_D`, so only a scenario or a person can set that state: add a "
      "transition\n"
      "/devices/L_P_D/states/0: nothing leads to `MID` of `L_P_D`, so only a scenario or a person can set that state: "
      "add "
      "a transition");
}

TEST_CASE("A device that the plant does not drive, or with user code, may be in any state") {
  description::DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", "L_P_B.ON")};
  CHECK(analyse_described(two_devices(), describing({d})).fired(diag::Severity::warning) == "");
  description::DeviceDescription e = device("L_P_E");
  e.only = true;
  e.behaviour = "MyMachine";
  d.transitions = {transition("P1", "P2", "L_P_E.A2")};
  CHECK(analyse_described(two_devices(), describing({d, e})).fired(diag::Severity::warning) == "");
}

TEST_CASE("A missing symbol is reported as such, and only once") {
  std::vector<Row> rows = two_devices();
  rows.push_back({"L_P_D_I_P3", "", "BOOL", "FALSE", "%IX90"});
  rows.push_back({"L_P_E_I_HOT", "", "BOOL", "FALSE", "%IX91"});
  const Analysed list = analyse_described(rows, describing({device(), device("L_P_E")}));
  CHECK(list.fired(diag::Severity::warning) == "event-without-operation");
}

// Conditions.

TEST_CASE("A condition in several transitions of a device is reported once") {
  description::DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", "L_P_E.A1 and L_P_E.A2"), transition("P2", "P1", "L_P_E.A1 and L_P_E.A2")};
  CHECK(reported(analyse_described(two_devices(), describing({d})), "condition-decided") ==
        "/devices/L_P_D/transitions/0/when: `L_P_E.A1 and L_P_E.A2` can never hold: correct it");
}

TEST_CASE("The `while` of a move is checked as its `when` is") {
  description::DeviceDescription d = device();
  d.transitions = {transition("P1", "P2"), transition("P2", "P1")};
  d.transitions[0].during = "L_P_E.A1 and L_P_E.A2";
  d.transitions[1].during = "not L_P_E.A1 or not L_P_E.A2";
  const Analysed analysed = analyse_described(two_devices(), describing({d}));
  CHECK(reported(analysed, "condition-decided") ==
        "/devices/L_P_D/transitions/0/while: `L_P_E.A1 and L_P_E.A2` can never hold: correct it\n"
        "/devices/L_P_D/transitions/1/while: `not L_P_E.A1 or not L_P_E.A2` always holds: correct it");
}

TEST_CASE("Inputs of a behavior are checked, too") {
  description::DeviceDescription d = device();
  d.behaviour = "MyOwn";
  d.inputs = {{"fast", "L_P_E_I_SPEED > 5 or not L_P_E_I_SPEED > 5"}, {"part", "L_P_E.A1"}};
  CHECK(reported(analyse_described(two_devices(), describing({d})), "condition-decided") ==
        "/devices/L_P_D/inputs/fast: `L_P_E_I_SPEED > 5 or not L_P_E_I_SPEED > 5` always holds: correct it");
}

TEST_CASE("A description with faults is not checked further") {
  description::DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", "L_P_E.A1 and L_P_E.A2"), transition("P1", "P9")};
  CHECK(analyse_described(two_devices(), describing({d})).fired(diag::Severity::warning) == "");
}

// Requirements.

std::string of_requirement(description::GivenRequirement given,
                           std::vector<description::DeviceDescription> devices = {}) {
  description::Description description = describing(std::move(devices));
  description.requirements = {std::move(given)};
  return reported(analyse_described(two_devices(), std::move(description)), "condition-decided");
}

TEST_CASE("A requirement that cannot be violated, or always is, is reported") {
  CHECK(of_requirement({"r", "L_P_D.P1 and L_P_D.P2", "", "", 0}) ==
        "/requirements/0/never: `L_P_D.P1 and L_P_D.P2` can never hold: correct it");
  CHECK(of_requirement({"r", "L_P_D.P1 or not L_P_D.P1", "", "", 0}) ==
        "/requirements/0/never: `L_P_D.P1 or not L_P_D.P1` always holds: correct it");
  CHECK(of_requirement({"r", "L_P_D.P1 and L_P_E.A1", "", "", 0}) == "");
}

TEST_CASE("A requirement with an unreachable state is reported") {
  description::DeviceDescription d = device();
  d.states = {"FAULT"};
  CHECK(of_requirement({"r", "", "L_P_D.FAULT", "L_P_E.A1", 0}, {d}) ==
        "/requirements/0/after: `L_P_D.FAULT` can never hold: correct it");
  CHECK(of_requirement({"r", "", "L_P_E.A1", "L_P_D.FAULT", 0}, {d}) ==
        "/requirements/0/expect: `L_P_D.FAULT` can never hold: correct it");
  CHECK(of_requirement({"r", "", "L_P_E.A1", "L_P_D.P1 or L_P_B_I_ON", 0}, {d}) == "");
}

}  // namespace
}  // namespace symplant::test
