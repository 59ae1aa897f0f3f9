// Findings on descriptions: states, loops, circles, conditions, requirements.
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
  d.transitions = {transition("MID", "P2"), transition("P2", "MID"), transition("P2", "P1")};
  d.transitions[1].on = "P1";
  CHECK(reported(analyse_described(two_devices(), describing({d})), "unreachable-state") ==
        "/devices/L_P_D/states/0: nothing leads to `MID` of `L_P_D`, only a scenario or a person can put it there: see "
        "why the transitions to it never fire [/devices/L_P_D/transitions/1: a transition to it, but from a state that "
        "nothing leads to]\n"
        "/devices/L_P_D/only: nothing leads to `P2` of `L_P_D`, only a scenario or a person can put it there: see why "
        "the transitions to it never fire [/devices/L_P_D/transitions/0: a transition to it, but from a state that "
        "nothing leads to]");
}

TEST_CASE("Two devices that wait for each other reach neither state") {
  description::DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", "L_P_E.A2")};
  description::DeviceDescription e = device("L_P_E");
  e.transitions = {transition("A1", "A2", "L_P_D.P2")};
  const Analysed list = analyse_described(two_devices(), describing({d, e}));
  CHECK(list.count("unreachable-state") == 2);
  CHECK(list.count("state-never-left") == 2);
  CHECK(list.count("condition-never-holds") == 0);
  e.transitions = {transition("A1", "A2", "L_P_D.P1")};
  CHECK(analyse_described(two_devices(), describing({d, e})).fired(diag::Severity::warning) == "");
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

TEST_CASE("What follows an automatic transition without condition and time is never taken") {
  description::DeviceDescription d = device();
  d.states = {"MID"};
  d.only = true;
  d.transitions = {by_itself("P1", "MID"), transition("P1", "P2"), transition("MID", "P1")};
  CHECK(reported(analyse_described(two_devices(), describing({d})), "unreachable-state") ==
        "/devices/L_P_D/only: nothing leads to `P2` of `L_P_D`, only a scenario or a person can put it there: see why "
        "the transitions to it never fire [/devices/L_P_D/transitions/1: a transition to it, but an automatic "
        "transition leaves its first state before]");
  d.transitions[0].after = description::Duration::fixed(1);
  CHECK(analyse_described(two_devices(), describing({d})).count("unreachable-state") == 0);
}

TEST_CASE("A missing symbol is reported as such, and only once") {
  std::vector<Row> rows = two_devices();
  rows.push_back({"L_P_D_I_P3", "", "BOOL", "FALSE", "%IX90"});
  rows.push_back({"L_P_E_I_HOT", "", "BOOL", "FALSE", "%IX91"});
  const Analysed list = analyse_described(rows, describing({device(), device("L_P_E")}));
  CHECK(list.fired(diag::Severity::warning) == "event-without-operation");
}

// States that cannot be left.

TEST_CASE("A state that commands leave but that has no transition out is reported") {
  description::DeviceDescription d = device();
  d.only = true;
  d.transitions = {transition("P1", "P2")};
  CHECK(reported(analyse_described(two_devices(), describing({d})), "state-never-left") ==
        "/devices/L_P_D/only: `L_P_D` never leaves `P2`, though `L_P_D_O_P1` commands it away: add a transition that "
        "leads out");
  d.transitions.push_back(by_itself("P2", "P1"));
  CHECK(analyse_described(two_devices(), describing({d})).count("state-never-left") == 0);
}

TEST_CASE("A state that no operation leaves may be the last") {
  description::DeviceDescription d = device();
  d.only = true;
  d.actuation = tables::Actuation::latched;
  d.transitions = {transition("NOT_ON", "ON")};
  CHECK(analyse_described(bits({"L_P_D_O_ON", "L_P_D_I_ON"}), describing({d})).count("state-never-left") == 0);
}

// Zero-time loops.

TEST_CASE("A circle of automatic transitions is reported once, whatever leads into it") {
  description::DeviceDescription d = device();
  d.states = {"A", "B"};
  d.transitions = {by_itself("P1", "A"), by_itself("A", "B"), by_itself("B", "A", "L_P_E.A1 or not L_P_E.A1")};
  CHECK(reported(analyse_described(two_devices(), describing({d})), "zero-time-loop") ==
        "/devices/L_P_D/transitions/1: `L_P_D` goes `A` -> `B` -> `A` without a command and without time passing, so "
        "it freezes "
        "when it runs: give one of these transitions an `after`, a `takes` or a `when` [/devices/L_P_D/transitions/2: "
        "and this one leads on]");
}

TEST_CASE("A time, a condition or user code in the circle prevents the finding") {
  description::DeviceDescription d = device();
  d.transitions = {by_itself("P1", "P2"), by_itself("P2", "P1")};
  const auto count = [&] { return analyse_described(two_devices(), describing({d})).count("zero-time-loop"); };
  CHECK(count() == 1);
  d.transitions[0].takes = description::Duration::fixed(1);
  CHECK(count() == 0);
  d.transitions[0].takes.reset();
  d.transitions[1].after = description::Duration{description::Duration::Kind::uniform, 0, 1};
  CHECK(count() == 0);
  d.transitions[1].after.reset();
  d.transitions[1].when = "L_P_E.A1";
  CHECK(count() == 0);
  d.transitions[1].when.clear();
  d.behaviour = "MyOwn";
  CHECK(count() == 0);
}

// Circles of disables.

std::vector<Row> ring(int devices) {
  std::vector<std::string> names;
  for (int i = 0; i < devices; ++i) {
    for (const char* task : {"_O_P1", "_I_P1", "_O_P2", "_I_P2"}) names.push_back("L_P_R" + std::to_string(i) + task);
  }
  return bits(names);
}

description::DeviceDescription disabling(const std::string& path, std::vector<std::string> others) {
  description::DeviceDescription d = device(path);
  d.disables = {{"P2", std::move(others)}};
  return d;
}

TEST_CASE("A circle of disables is reported once, with its members") {
  const auto described = describing({disabling("L_P_R0", {"L_P_R1"}), disabling("L_P_R1", {"L_P_R2"}),
                                     disabling("L_P_R2", {"L_P_R0"}), disabling("L_P_R3", {"L_P_R0"})});
  CHECK(reported(analyse_described(ring(4), described), "cycle-of-disables") ==
        "/devices/L_P_R0/disables/P2: `L_P_R0` in `P2` disables `L_P_R1`, `L_P_R1` in `P2` disables `L_P_R2`, `L_P_R2` "
        "in `P2` disables `L_P_R0`: once all are in these states, none can leave; remove one of these "
        "[/devices/L_P_R1/disables/P2: `L_P_R1` disables `L_P_R2` here] "
        "[/devices/L_P_R2/disables/P2: `L_P_R2` disables `L_P_R0` here]");
}

TEST_CASE("Two separate circles are two findings, two that share a device are one") {
  CHECK(analyse_described(ring(4), describing({disabling("L_P_R0", {"L_P_R1"}), disabling("L_P_R1", {"L_P_R0"}),
                                               disabling("L_P_R2", {"L_P_R3"}), disabling("L_P_R3", {"L_P_R2"})}))
            .count("cycle-of-disables") == 2);
  const Analysed shared =
      analyse_described(ring(3), describing({disabling("L_P_R0", {"L_P_R1", "L_P_R2"}), disabling("L_P_R1", {"L_P_R0"}),
                                             disabling("L_P_R2", {"L_P_R0"})}));
  CHECK(shared.count("cycle-of-disables") == 1);
  CHECK(reported(shared, "cycle-of-disables").find("(1 more devices are in cycles with them)") != std::string::npos);
  CHECK(analyse_described(ring(3), describing({disabling("L_P_R0", {"L_P_R1"}), disabling("L_P_R1", {"L_P_R2"})}))
            .count("cycle-of-disables") == 0);
}

// Conditions.

TEST_CASE("A condition in several transitions of a device is reported once") {
  description::DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", "L_P_E.A1 and L_P_E.A2"), transition("P2", "P1", "L_P_E.A1 and L_P_E.A2")};
  CHECK(reported(analyse_described(two_devices(), describing({d})), "condition-never-holds") ==
        "/devices/L_P_D/transitions/0/when: `L_P_E.A1 and L_P_E.A2` can never hold, so that the transition is never "
        "taken: correct it");
}

TEST_CASE("The `while` of a move is checked as its `when` is") {
  description::DeviceDescription d = device();
  d.transitions = {transition("P1", "P2"), transition("P2", "P1")};
  d.transitions[0].during = "L_P_E.A1 and L_P_E.A2";
  d.transitions[1].during = "not L_P_E.A1 or not L_P_E.A2";
  const Analysed analysed = analyse_described(two_devices(), describing({d}));
  CHECK(reported(analysed, "condition-never-holds") ==
        "/devices/L_P_D/transitions/0/while: `L_P_E.A1 and L_P_E.A2` can never hold, so that the move never ends: "
        "correct it");
  CHECK(reported(analysed, "condition-always-holds") ==
        "/devices/L_P_D/transitions/1/while: `not L_P_E.A1 or not L_P_E.A2` always holds, so that it never stops the "
        "move: correct or remove it");
}

TEST_CASE("Inputs of a behavior are checked, too") {
  description::DeviceDescription d = device();
  d.behaviour = "MyOwn";
  d.inputs = {{"fast", "L_P_E_I_SPEED > 5 or L_P_E_I_SPEED < 6"}, {"part", "L_P_E.A1"}};
  CHECK(reported(analyse_described(two_devices(), describing({d})), "condition-always-holds") ==
        "/devices/L_P_D/inputs/fast: `L_P_E_I_SPEED > 5 or L_P_E_I_SPEED < 6` always holds, so that this input is "
        "always on: correct or remove it");
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
  return reported(analyse_described(two_devices(), std::move(description)), "requirement-decided");
}

TEST_CASE("A requirement that cannot be violated, or always is, is reported") {
  CHECK(of_requirement({"r", "L_P_D.P1 and L_P_D.P2", "", "", 0}) ==
        "/requirements/0/never: requirement `r`: `L_P_D.P1 and L_P_D.P2` can never hold: it cannot be violated, and "
        "tests nothing");
  CHECK(of_requirement({"r", "L_P_D.P1 or not L_P_D.P1", "", "", 0}) ==
        "/requirements/0/never: requirement `r`: `L_P_D.P1 or not L_P_D.P1` always holds: it is violated from the "
        "start");
  CHECK(of_requirement({"r", "L_P_D.P1 and L_P_E.A1", "", "", 0}) == "");
}

TEST_CASE("A requirement with an unreachable state is reported") {
  description::DeviceDescription d = device();
  d.states = {"FAULT"};
  CHECK(of_requirement({"r", "", "L_P_D.FAULT", "L_P_E.A1", 0}, {d}) ==
        "/requirements/0/after: requirement `r`: `L_P_D.FAULT` can never hold, since nothing leads to a state that it "
        "names: it never begins, and tests nothing");
  CHECK(of_requirement({"r", "", "L_P_E.A1", "L_P_D.FAULT", 0}, {d}) ==
        "/requirements/0/expect: requirement `r`: `L_P_D.FAULT` can never hold, since nothing leads to a state that it "
        "names: it is violated whenever it begins");
  CHECK(of_requirement({"r", "", "L_P_E.A1", "L_P_D.P1 or L_P_B_I_ON", 0}, {d}) == "");
}

}  // namespace
}  // namespace symplant::test
