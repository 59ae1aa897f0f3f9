// What a description defines about states, actuation, rest and the initial state.
#include "description_support.hpp"

namespace symplant::test {
namespace {

using model::InitialFrom;
using tables::Actuation;

const std::vector<std::string> kCylinder = {"L_P_D_O_ADV", "L_P_D_I_ADV", "L_P_D_I_RET"};
const std::vector<std::string> kTable = {"L_P_D_O_P1", "L_P_D_I_P1", "L_P_D_O_P2", "L_P_D_I_P2"};

TEST_CASE("A plant without a description has an empty one") {
  const Analysed list = analyse_rows(bits(kTable));
  REQUIRE(list.model().description != nullptr);
  CHECK(list.model().description->devices.empty());
  CHECK(list.evidence().faults.empty());
  CHECK(unit_of(list).described == nullptr);
}

TEST_CASE("Added states come after those that symbols name, in their order") {
  DeviceDescription d = device();
  d.states = {"DOCK", "A0"};
  const Analysed list = described(kTable, {d});
  CHECK(faults(list) == "");
  CHECK(states_text(unit_of(list)) == "P1 P2 DOCK A0");
  CHECK(unit_of(list).states[2].operation == model::kNone);
  CHECK(unit_of(list).states[2].event == model::kNone);
  CHECK(initial_text(unit_of(list)) == "P1");
  CHECK(unit_of(list).described->path == "L_P_D");
  CHECK(transitions_text(list, unit_of(list)) ==
        "P2-O_P1>P1 DOCK-O_P1>P1 A0-O_P1>P1 P1-O_P2>P2 DOCK-O_P2>P2 A0-O_P2>P2");
}

TEST_CASE("A device is found in any case") {
  DeviceDescription d = device("l_p_d");
  d.initial = "p2";
  CHECK(initial_text(unit_of(described(kTable, {d}))) == "P2");
}

TEST_CASE("A state that symbols name, and one named twice, cannot be added") {
  DeviceDescription d = device();
  d.states = {"p1", "DOCK", "dock", ""};
  const Analysed list = described(kTable, {d});
  CHECK(faults(list) ==
        "/devices/L_P_D/states/0: `p1` is already a state of `L_P_D` by its symbols; remove it\n"
        "/devices/L_P_D/states/2: `dock` appears twice; remove it\n"
        "/devices/L_P_D/states/3: `` is not a valid name of a state; choose another");
  CHECK(states_text(unit_of(list)) == "P1 P2 DOCK");
}

TEST_CASE("A device may have 250 states, including added ones") {
  DeviceDescription d = device();
  for (int i = 0; i < 248; ++i) d.states.push_back("S" + std::to_string(i));
  const Analysed exact = described(kTable, {d});
  CHECK(faults(exact) == "");
  CHECK(unit_of(exact).states.size() == 250);
  d.states.push_back("S248");
  CHECK(faults(described(kTable, {d})) ==
        "/devices/L_P_D/states: the device has more than 250 states, including those of its symbols; remove some");
}

TEST_CASE("An unknown device is reported with the nearest one") {
  CHECK(faults(described(kTable, {device("L_P_E")})) ==
        "/devices/L_P_E: device `L_P_E` not found; did you mean `L_P_D`?");
  CHECK(faults(described(kTable, {device("A/B~C")})) == "/devices/A~1B~0C: device `A/B~C` not found");
}

TEST_CASE("A device described twice is a fault") {
  CHECK(faults(described(kTable, {device(), device("l_p_d")})) ==
        "/devices/l_p_d: `l_p_d` is described twice; merge both");
}

TEST_CASE("A device with too many symbols cannot be described") {
  std::vector<std::string> names;
  for (int i = 0; i < 65; ++i) names.push_back("L_P_D_O_T" + std::to_string(i));
  CHECK(faults(described(names, {device()})) ==
        "/devices/L_P_D: `L_P_D` has too many symbols for a device and is not modelled; remove its description");
}

// Commands and events that are not states.

TEST_CASE("An operation without event that only commands given transitions is no state and derives nothing") {
  DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", "index"), transition("P2", "P1", "INDEX")};
  const Analysed list = described({"L_P_D_I_P1", "L_P_D_I_P2", "L_P_D_O_INDEX"}, {d});
  CHECK(faults(list) == "");
  CHECK(states_text(unit_of(list)) == "P1 P2");
  CHECK(transitions_text(list, unit_of(list)) == "P1-O_INDEX>P2 P2-O_INDEX>P1");
  CHECK(unit_of(list).operations.size() == 1);
}

TEST_CASE("A command is a state if it has an event, or is named as a state anywhere") {
  const std::vector<std::string> names = {"L_P_D_I_P1", "L_P_D_I_P2", "L_P_D_O_INDEX"};
  DeviceDescription plain = device();
  plain.transitions = {transition("P1", "P2", "INDEX")};
  CHECK(states_text(unit_of(described({"L_P_D_I_P1", "L_P_D_I_P2", "L_P_D_O_INDEX", "L_P_D_I_INDEX"}, {plain}))) ==
        "P1 P2 INDEX");
  CHECK(states_text(unit_of(described(names, {device()}))) == "P1 P2 INDEX");

  std::vector<DeviceDescription> named(6, plain);
  named[0].transitions.push_back(automatic("INDEX", "P1"));
  named[1].transitions.push_back(transition("P1", "INDEX"));
  named[2].initial = "INDEX";
  named[3].outputs = {{"INDEX", {{"P1", true}}, {}}};
  named[4].disables = {{"INDEX", {}}};
  named[5].rest = "index";
  named[5].actuation = Actuation::spring;
  for (const DeviceDescription& d : named) {
    const Analysed list = described(names, {d});
    CHECK(faults(list) == "");
    CHECK(states_text(unit_of(list)) == "P1 P2 INDEX");
  }
}

TEST_CASE("An event without operation that outputs switch is no state") {
  DeviceDescription d = device();
  d.outputs = {{"P2", {{"BUSY", true}}, {{"busy", false}}}};
  std::vector<std::string> names = kTable;
  names.push_back("L_P_D_I_BUSY*");
  const Analysed list = described(names, {d});
  CHECK(faults(list) == "");
  CHECK(states_text(unit_of(list)) == "P1 P2");
  CHECK(unit_evidence(list).initial_candidates == 0);  // its Initial does not define a state
  CHECK(initial_text(unit_of(list)) == "P1");
}

TEST_CASE("An event that outputs switch is a state if it has an operation, or is named as a state") {
  std::vector<std::string> names = kTable;
  names.push_back("L_P_D_I_BUSY");
  DeviceDescription d = device();
  d.outputs = {{"P2", {{"BUSY", true}}, {}}};
  DeviceDescription initial = d;
  initial.initial = "BUSY";
  CHECK(states_text(unit_of(described(names, {initial}))) == "P1 P2 BUSY");
  names.push_back("L_P_D_O_BUSY");
  CHECK(states_text(unit_of(described(names, {d}))) == "P1 P2 BUSY");
}

// Actuation and rest.

TEST_CASE("A given actuation overrides an inferred one, and that overrides the default") {
  description::Description description;
  description.defaults.actuation = Actuation::held;
  CHECK(unit_of(analyse_described(bits(kTable), description)).actuation == Actuation::held);
  CHECK(unit_of(analyse_described(bits(kCylinder), description)).actuation == Actuation::spring);
  DeviceDescription d = device();
  d.actuation = Actuation::bistable;
  description.devices = {d};
  CHECK(unit_of(analyse_described(bits(kTable), description)).actuation == Actuation::bistable);
  CHECK(unit_of(analyse_described(bits(kCylinder), description)).actuation == Actuation::bistable);
}

TEST_CASE("With another given actuation the inferred rest is only the initial state") {
  DeviceDescription d = device();
  d.actuation = Actuation::latched;
  const Analysed cylinder = described({"L_P_D_O_ADV", "L_P_D_I_ADV", "L_P_D_I_RET"}, {d});
  CHECK(initial_text(unit_of(cylinder)) == "RET");
  CHECK(unit_of(cylinder).initial_from == InitialFrom::rest_state);
  CHECK_FALSE(unit_of(cylinder).reaches(1));
  const Analysed lamp = described({"L_P_D_O_RUN", "L_P_D_I_RUN"}, {d});
  CHECK(states_text(unit_of(lamp)) == "NOT_RUN RUN");
  CHECK(initial_text(unit_of(lamp)) == "NOT_RUN");
  CHECK_FALSE(springs(unit_of(lamp)));
}

TEST_CASE("A given rest overrides the inferred one") {
  DeviceDescription d = device();
  d.rest = "ADV";
  const Analysed list = described(kCylinder, {d});
  CHECK(faults(list) == "");
  CHECK(rest_text(unit_of(list)) == "ADV");
  CHECK(initial_text(unit_of(list)) == "ADV");
}

TEST_CASE("A spring without given or inferred rest rests in its initial state") {
  DeviceDescription d = device();
  d.actuation = Actuation::spring;
  CHECK(rest_text(unit_of(described(kTable, {d}))) == "P1");
  d.initial = "P2";
  CHECK(rest_text(unit_of(described(kTable, {d}))) == "P2");
  d.rest = "P1";
  const Analysed both = described(kTable, {d});
  CHECK(rest_text(unit_of(both)) == "P1");
  CHECK(initial_text(unit_of(both)) == "P2");
}

TEST_CASE("A rest in a device without a spring is a fault") {
  DeviceDescription d = device();
  d.rest = "P1";
  CHECK(faults(described(kTable, {d})) ==
        "/devices/L_P_D/rest: `L_P_D` is `latched`, but only a `spring` has a rest state; remove `rest` or set "
        "`actuation` to `spring`");
}

TEST_CASE("A state added with only an event, next to an operation, is the rest of a single solenoid") {
  DeviceDescription d = device();
  d.states = {"RET"};
  const Analysed list = described({"L_P_D_O_ADV", "L_P_D_I_ADV"}, {d});
  CHECK(states_text(unit_of(list)) == "ADV RET");
  CHECK(springs(unit_of(list)));
  CHECK(rest_text(unit_of(list)) == "RET");
}

TEST_CASE("An operation without event next to an added state is no pair of words") {
  DeviceDescription d = device();
  d.states = {"OFF"};
  const Analysed list = described({"L_P_D_O_ON"}, {d});
  CHECK_FALSE(unit_evidence(list).two_words);
  CHECK_FALSE(springs(unit_of(list)));
}

// The initial state.

TEST_CASE("A given initial state overrides Initial columns, and two of those are then not ambiguous") {
  DeviceDescription d = device();
  d.initial = "P2";
  const Analysed list = described({"L_P_D_O_P1", "L_P_D_I_P1*", "L_P_D_O_P2", "L_P_D_I_P2", "L_P_D_I_P3*"}, {d});
  CHECK(initial_text(unit_of(list)) == "P2");
  CHECK(unit_of(list).initial_from == InitialFrom::description);
  CHECK(unit_evidence(list).initial_candidates == 0);
  CHECK(list.count("initial-ambiguous") == 0);
}

TEST_CASE("A description may name a state that inference adds") {
  DeviceDescription d = device();
  d.initial = "RUN";
  d.transitions = {taking(transition("RUN", "NOT_RUN"), tables::kSecond / 2)};
  const Analysed list = described({"L_P_D_O_RUN", "L_P_D_I_RUN"}, {d});
  CHECK(faults(list) == "");
  CHECK(initial_text(unit_of(list)) == "RUN");
}

TEST_CASE("An unknown initial or rest state is reported with the nearest one") {
  DeviceDescription d = device();
  d.initial = "ADW";
  d.rest = "REST";
  CHECK(faults(described(kCylinder, {d})) ==
        "/devices/L_P_D/rest: state `REST` of `L_P_D` not found; did you mean `RET`?\n"
        "/devices/L_P_D/initial: state `ADW` of `L_P_D` not found; did you mean `ADV`?");
}

TEST_CASE("The order of rows decides the first of S only if symbols alone decide it") {
  DeviceDescription d = device();
  d.states = {"B", "C"};
  const Analysed list = described({"L_P_D_O_A", "L_P_D_I_A"}, {d});
  CHECK(initial_text(unit_of(list)) == "A");
  CHECK(unit_of(list).initial_from == InitialFrom::sequence);
}

}  // namespace
}  // namespace symplant::test
