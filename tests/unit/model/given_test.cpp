// Given transitions, what they replace, and their order; outputs.
#include "description_support.hpp"

namespace symplant::test {
namespace {

using model::Origin;
using tables::Actuation;
using tables::kSecond;

const std::vector<std::string> kThreeIndexes = {"L_P_D_O_P1", "L_P_D_I_P1", "L_P_D_O_P2",
                                                "L_P_D_I_P2", "L_P_D_O_P3", "L_P_D_I_P3"};
const std::vector<std::string> kPiston = {"L_P_D_O_ADV", "L_P_D_I_ADV", "L_P_D_I_RET"};

DeviceDescription with(std::vector<GivenTransition> transitions) {
  DeviceDescription d = device();
  d.transitions = std::move(transitions);
  return d;
}

TEST_CASE("Default times are those of the description") {
  description::Description description;
  description.defaults.travel = 3 * kSecond;
  description.defaults.dwell = 5 * kSecond;
  const Analysed list =
      analyse_described(bits({"L_P_D_O_RUN2", "L_P_D_I_RUN2", "L_P_D_I_IDLE1"}), std::move(description));
  const model::Unit& unit = unit_of(list);
  CHECK(unit.travel == 3 * kSecond);
  CHECK(transitions_text(list, unit) == "IDLE1-O_RUN2>RUN2 RUN2>IDLE1");
  CHECK(unit.transitions[0].takes == Duration::fixed(3 * kSecond));
  CHECK(unit.transitions[1].after == Duration::fixed(5 * kSecond));
  CHECK(unit.transitions[1].takes.is_zero());
}

TEST_CASE("Without a given time, a commanded transition takes the default travel time, an automatic one none") {
  GivenTransition timed = transition("P2", "P1");
  timed.after = Duration::fixed(7);
  timed.takes = Duration{Duration::Kind::uniform, 1, 2};
  const Analysed list = described(kThreeIndexes, {with({transition("P1", "P2"), automatic("P3", "P1"), timed})});
  CHECK(faults(list) == "");
  const auto& transitions = unit_of(list).transitions;
  CHECK(transitions[0].after.is_zero());
  CHECK(transitions[0].takes == Duration::fixed(kSecond));
  CHECK(transitions[1].on == model::kNone);
  CHECK(transitions[1].after.is_zero());
  CHECK(transitions[1].takes.is_zero());
  CHECK(transitions[2].after == Duration::fixed(7));
  CHECK(transitions[2].takes == Duration{Duration::Kind::uniform, 1, 2});
}

TEST_CASE("A commanded transition replaces every derived one with its source and operation") {
  const Analysed list = described(kThreeIndexes, {with({transition("P1", "P3", "P2")})});
  CHECK(transitions_text(list, unit_of(list)) == "P1-O_P2>P3 P2-O_P1>P1 P3-O_P1>P1 P3-O_P2>P2 P1-O_P3>P3 P2-O_P3>P3");
  CHECK(origins(unit_of(list)) == "gddddd");
}

TEST_CASE("An automatic transition replaces the inferred one of its source and target, not that of another source") {
  const std::vector<std::string> machine = {"L_P_D_O_RUN2", "L_P_D_I_RUN2", "L_P_D_I_IDLE1"};
  GivenTransition back = automatic("RUN2", "IDLE1");
  back.after = Duration::fixed(9);
  const Analysed list = described(machine, {with({back})});
  CHECK(transitions_text(list, unit_of(list)) == "RUN2>IDLE1 IDLE1-O_RUN2>RUN2");
  CHECK(unit_of(list).transitions[0].after == Duration::fixed(9));
  DeviceDescription other = with({automatic("WAIT", "IDLE1")});
  other.states = {"WAIT"};
  CHECK(transitions_text(described(machine, {other}), unit_of(described(machine, {other}))) ==
        "WAIT>IDLE1 IDLE1-O_RUN2>RUN2 WAIT-O_RUN2>RUN2 RUN2>IDLE1");
}

TEST_CASE("A numbered state that a given command leads to is not inferred to be automatic") {
  const Analysed list = described({"L_P_D_O_RUN2", "L_P_D_I_RUN2", "L_P_D_I_IDLE1", "L_P_D_O_STOP"},
                                  {with({transition("RUN2", "IDLE1", "STOP")})});
  CHECK(transitions_text(list, unit_of(list)) == "RUN2-O_STOP>IDLE1 IDLE1-O_RUN2>RUN2");
}

TEST_CASE("Added states count by their digits as predecessors") {
  DeviceDescription d = device();
  d.states = {"WAIT2"};
  const Analysed list = described({"L_P_D_O_RUN1", "L_P_D_I_RUN1", "L_P_D_I_DONE3"}, {d});
  CHECK(states_text(unit_of(list)) == "RUN1 DONE3 WAIT2");
  CHECK(transitions_text(list, unit_of(list)) == "DONE3-O_RUN1>RUN1 WAIT2-O_RUN1>RUN1 WAIT2>DONE3");
  d.states = {"A2", "B02"};
  const Analysed ambiguous = described({"L_P_D_O_RUN1", "L_P_D_I_RUN1", "L_P_D_I_DONE3"}, {d});
  CHECK(unit_evidence(ambiguous).ambiguous_sequence == std::vector<std::uint32_t>{1});
}

TEST_CASE("A sequence is inferred only in `latched` devices") {
  DeviceDescription d = device();
  d.actuation = Actuation::held;
  const Analysed list = described({"L_P_D_O_RUN2", "L_P_D_I_RUN2", "L_P_D_I_IDLE1"}, {d});
  CHECK(transitions_text(list, unit_of(list)) == "IDLE1-O_RUN2>RUN2");
}

TEST_CASE("`*` means every state except the target, in the order of S, after the transitions before it") {
  const Analysed list =
      described(kThreeIndexes, {with({transition("P3", "P1"), transition("*", "P2", "P1"), automatic("*", "P3")})});
  CHECK(faults(list) == "");
  CHECK(transitions_text(list, unit_of(list)) ==
        "P3-O_P1>P1 P1-O_P1>P2 P3-O_P1>P2 P1>P3 P2>P3 P2-O_P1>P1 P1-O_P2>P2 P3-O_P2>P2 P1-O_P3>P3 P2-O_P3>P3");
  CHECK(origins(unit_of(list)) == "gggggddddd");
}

TEST_CASE("`only` prevents derived and inferred transitions, but not states, rest and actuation") {
  DeviceDescription d = with({automatic("RET", "ADV")});
  d.only = true;
  const Analysed list = described(kPiston, {d});
  CHECK(transitions_text(list, unit_of(list)) == "RET>ADV");
  CHECK(springs(unit_of(list)));
  CHECK(rest_text(unit_of(list)) == "RET");
  DeviceDescription nothing = device();
  nothing.only = true;
  CHECK(unit_of(described({"L_P_D_O_RUN2", "L_P_D_I_RUN2", "L_P_D_I_IDLE1"}, {nothing})).transitions.empty());
  const Analysed lamp = described({"L_P_D_O_ON"}, {nothing});
  CHECK(states_text(unit_of(lamp)) == "NOT_ON ON");
  CHECK(springs(unit_of(lamp)));
}

TEST_CASE("In a spring a transition to rest without operation sets the time of the spring return") {
  const Analysed list = described(kPiston, {with({taking(transition("ADV", "RET"), 800)})});
  CHECK(faults(list) == "");
  const model::Transition& own = unit_of(list).transitions.front();
  CHECK(own.spring_return);
  CHECK(own.on == model::kNone);
  CHECK(own.takes == Duration::fixed(800));
  CHECK(origins(unit_of(list)) == "gd");
  DeviceDescription d = with({taking(transition("*", "RET"), 800)});
  d.states = {"MID"};
  d.actuation = Actuation::spring;
  d.rest = "RET";
  const Analysed all = described(kPiston, {d});
  CHECK(transitions_text(all, unit_of(all)) == "ADV>RET MID>RET RET-O_ADV>ADV MID-O_ADV>ADV");
  CHECK(unit_of(all).transitions[1].spring_return);
}

TEST_CASE("A rest state's operation commands it, and other operations or automatic transitions may lead to it") {
  DeviceDescription d = with({transition("P2", "P1")});
  d.actuation = Actuation::spring;
  CHECK_FALSE(unit_of(described(kThreeIndexes, {d})).transitions.front().spring_return);
  const Analysed list = described({"L_P_D_O_ADV", "L_P_D_I_ADV", "L_P_D_I_RET"},
                                  {with({transition("ADV", "RET", "ADV"), automatic("ADV", "RET")})});
  CHECK(faults(list) == "");
  CHECK_FALSE(unit_of(list).transitions[0].spring_return);
  CHECK_FALSE(unit_of(list).transitions[1].spring_return);
}

TEST_CASE("A spring return accepts only `takes` and `while`") {
  GivenTransition given = transition("ADV", "RET", "", "L_P_D_O_ADV");
  given.after = Duration::fixed(1);
  given.once = true;
  const std::string end =
      "is not allowed in the return of a spring, which has only `takes` and `while`; remove it, or name with `on` the "
      "operation that commands the transition";
  CHECK(faults(described(kPiston, {with({given})})) == "/devices/L_P_D/transitions/0/when: `when` " + end +
                                                           "\n/devices/L_P_D/transitions/0/after: `after` " + end +
                                                           "\n/devices/L_P_D/transitions/0/once: `once` " + end);
}

TEST_CASE("In other devices a transition to a state without operation reports what is missing") {
  DeviceDescription d = with({transition("ADV", "RET")});
  d.actuation = Actuation::latched;
  CHECK(faults(described(kPiston, {d})) ==
        "/devices/L_P_D/transitions/0/to: `RET` has no operation of its name; name with `on` the one that commands "
        "the transition, or write `automatic` if none does");
}

TEST_CASE("`once` is kept in commanded transitions of latched devices") {
  GivenTransition once = transition("P1", "P2");
  once.once = true;
  CHECK(unit_of(described(kThreeIndexes, {with({once})})).transitions.front().once);
  DeviceDescription held = with({once});
  held.actuation = Actuation::held;
  CHECK(faults(described(kThreeIndexes, {held})) ==
        "/devices/L_P_D/transitions/0/once: `once` is not allowed in a device that is `held`; remove it or make the "
        "device "
        "`latched`");
  GivenTransition by_itself = automatic("P1", "P2");
  by_itself.once = true;
  CHECK(faults(described(kThreeIndexes, {with({by_itself})})) ==
        "/devices/L_P_D/transitions/0/once: `once` is not allowed in an automatic transition; remove it");
}

TEST_CASE("Unknown states and operations are reported with the nearest ones, all in one run") {
  CHECK(faults(described(kThreeIndexes, {with({transition("P9", "Q2", "P4"), transition("*", "*")})})) ==
        "/devices/L_P_D/transitions/0/to: state `Q2` of `L_P_D` not found; did you mean `P2`?\n"
        "/devices/L_P_D/transitions/0/from: state `P9` of `L_P_D` not found; did you mean `P1`?\n"
        "/devices/L_P_D/transitions/0/on: operation `P4` of `L_P_D` not found; did you mean `P1`?\n"
        "/devices/L_P_D/transitions/1/to: state `*` of `L_P_D` not found");
}

TEST_CASE("A transition to itself, and an automatic one with an operation, are faults") {
  GivenTransition both = automatic("P1", "P2");
  both.on = "P2";
  CHECK(faults(described(kThreeIndexes, {with({transition("P1", "p1"), both})})) ==
        "/devices/L_P_D/transitions/0: a transition cannot lead from `p1` to itself; name two states\n"
        "/devices/L_P_D/transitions/1/on: an automatic transition has no operation; remove `on` or `automatic`");
}

TEST_CASE("A repeated source, target, operation and text of `when` is a fault, after `*` is expanded") {
  const std::string when = "L_P_D_I_P3";
  CHECK(faults(described(kThreeIndexes, {with({transition("P1", "P2"), transition("P1", "P2", "P2")})})) ==
        "/devices/L_P_D/transitions/1: the transition from `P1` to `P2` is also at `/devices/L_P_D/transitions/0`, "
        "with the same `on` and `when`; remove one");
  CHECK(faults(described(kThreeIndexes, {with({transition("P3", "P2", "", when), transition("*", "P2", "", when)})})) ==
        "/devices/L_P_D/transitions/1: the transition from `P3` to `P2` is also at `/devices/L_P_D/transitions/0`, "
        "with the same `on` and `when`; remove one");
  // Another operation, another condition, another cause: other transitions.
  CHECK(faults(described(kThreeIndexes,
                         {with({transition("P1", "P2"), transition("P1", "P2", "P3"), transition("P1", "P2", "", when),
                                automatic("P1", "P2"), transition("*", "P3")})})) == "");
}

TEST_CASE("A device may have 65534 transitions") {
  DeviceDescription d = device();
  for (int i = 0; i < 246; ++i) d.states.push_back("S" + std::to_string(i));
  for (int i = 0; i < 300; ++i) {
    d.transitions.push_back(automatic("*", "P1", "L_P_D_I_P2 and L_P_N_I_V = " + std::to_string(i)));
  }
  auto rows = bits({"L_P_D_O_P1", "L_P_D_I_P1", "L_P_D_I_P2"});
  rows.push_back({"L_P_N_I_V", "", "INT", "0", "%IW7"});
  const Analysed list = analyse_described(rows, describing({d}));
  CHECK(faults(list) ==
        "/devices/L_P_D/transitions: the device has more than 65534 transitions, where a `*` counts once for each "
        "state; remove some");
  CHECK(unit_of(list).transitions.size() <= tables::kMaxTransitions);
}

// Outputs.

TEST_CASE("Outputs are further events on entering and leaving, in their order") {
  std::vector<std::string> names = kThreeIndexes;
  names.push_back("L_P_D_I_BUSY");
  names.push_back("L_P_D_I_FAULT");
  DeviceDescription d = device();
  d.outputs = {{"P2", {{"FAULT", false}, {"BUSY", true}}, {{"busy", false}}}};
  const Analysed list = described(names, {d});
  CHECK(faults(list) == "");
  const model::Unit& unit = unit_of(list);
  REQUIRE(unit.outputs.size() == 3);
  CHECK(unit.outputs[1].enter == std::vector<std::pair<std::uint32_t, bool>>{{4, false}, {3, true}});
  CHECK(unit.outputs[1].leave == std::vector<std::pair<std::uint32_t, bool>>{{3, false}});
  CHECK(unit.outputs[0].enter.empty());
  CHECK(unit.moves_event(3));
  CHECK(unit.moves_event(4));
}

TEST_CASE("An event that outputs of a state switch is driven if the device can enter that state") {
  DeviceDescription d = device();
  d.states = {"NEVER"};
  d.outputs = {{"NEVER", {{"BUSY", true}}, {}}};
  std::vector<std::string> names = kThreeIndexes;
  names.push_back("L_P_D_I_BUSY");
  CHECK_FALSE(unit_of(described(names, {d})).moves_event(3));
  d.transitions = {automatic("P1", "NEVER")};
  CHECK(unit_of(described(names, {d})).moves_event(3));
}

TEST_CASE("Outputs of unknown states and events are faults") {
  DeviceDescription d = device();
  d.outputs = {{"P7", {{"P1", true}}, {}}, {"P1", {{"BUSI", true}}, {{"P4", false}}}, {"p1", {}, {}}};
  CHECK(faults(described({"L_P_D_O_P1", "L_P_D_I_P1", "L_P_D_O_P2", "L_P_D_I_P2"}, {d})) ==
        "/devices/L_P_D/outputs/P7: state `P7` of `L_P_D` not found; did you mean `P1`?\n"
        "/devices/L_P_D/outputs/P1/enter/BUSI: event `BUSI` of `L_P_D` not found\n"
        "/devices/L_P_D/outputs/P1/leave/P4: event `P4` of `L_P_D` not found; did you mean `P1`?\n"
        "/devices/L_P_D/outputs/p1: `p1` appears twice; merge both");
}

}  // namespace
}  // namespace symplant::test
