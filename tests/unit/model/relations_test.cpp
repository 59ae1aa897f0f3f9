// Relations between units: conditions, disables, behaviors, requirements.
#include "description_support.hpp"

namespace symplant::test {
namespace {

using condition::Atom;
using condition::Tree;

const std::vector<std::string> kCell = {"L_P_D_O_P1", "L_P_D_I_P1", "L_P_D_O_P2", "L_P_D_I_P2",
                                        "L_P_E_O_A1", "L_P_E_I_A1", "L_P_E_O_A2", "L_P_E_I_A2"};

std::vector<Row> cell_with_numbers() {
  std::vector<Row> rows = bits(kCell);
  rows.push_back({"L_P_D_I_SPEED", "", "INT", "0", "%IW20"});
  rows.push_back({"L_P_E_O_SET", "", "REAL", "0", "%QD20"});
  rows.push_back({"l_p_d_O_LIMIT", "", "DINT", "0", "%QD30"});
  return rows;
}

TEST_CASE("A `when` becomes a tree over the plant") {
  DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", "", "not l_p_e.A2 and L_P_D_I_SPEED < 3.5 or L_P_E.moving and L_P_E_O_A1")};
  const Analysed list = analyse_described(cell_with_numbers(), describing({d}));
  REQUIRE(faults(list) == "");
  const model::Unit& unit = unit_of(list);
  CHECK(unit.transitions.front().when == 0);
  CHECK(unit.transitions.back().when == model::kNone);
  REQUIRE(unit.conditions.size() == 1);
  const Tree& any = unit.conditions.front();
  REQUIRE(any.kind == Tree::Kind::any);
  const Tree& first = any.children[0];
  CHECK(first.children[0].kind == Tree::Kind::negation);
  CHECK(first.children[0].children[0].atom.of == 1);
  CHECK(first.children[0].children[0].atom.state == 1);
  CHECK(first.children[1].atom.kind == Atom::Kind::number);
  CHECK(first.children[1].atom.of == 8);
  CHECK(first.children[1].atom.operand == 3);
  CHECK(first.children[1].atom.comparison == tables::Comparison::less_equal);
  CHECK(any.children[1].children[0].atom.kind == Atom::Kind::moving);
  CHECK(any.children[1].children[1].atom.kind == Atom::Kind::bit);
  CHECK(any.children[1].children[1].atom.of == 4);
}

TEST_CASE("Equal texts within a device share one condition, and `*` has one") {
  DeviceDescription d = device();
  d.transitions = {transition("*", "P2", "", "L_P_E.A1"), transition("P2", "P1", "", "L_P_E.A2"),
                   automatic("P1", "P2", "L_P_E.A1")};
  DeviceDescription e = device("L_P_E");
  e.transitions = {transition("A1", "A2", "", "L_P_D.P1")};
  const Analysed list = described(kCell, {d, e});
  REQUIRE(faults(list) == "");
  const model::Unit& unit = unit_of(list);
  CHECK(unit.conditions.size() == 2);
  CHECK(unit.transitions[0].when == 0);
  CHECK(unit.transitions[1].when == 1);
  CHECK(unit.transitions[2].when == 0);
  CHECK(unit.first_input == 2);
  CHECK(unit_of(list, "L_P_E").conditions.size() == 1);
}

TEST_CASE("A fault in a condition is reported at its location in the text, in every transition with it") {
  DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", "", "L_P_E.A1 and L_P_E.A9"),
                   transition("P2", "P1", "", "L_P_E.A1 and L_P_E.A9"), automatic("P1", "P2", "(L_P_E.A1")};
  const Analysed list = described(kCell, {d});
  CHECK(faults(list) ==
        "/devices/L_P_D/transitions/0/when: state `A9` of `L_P_E` not found; did you mean `A1`?\n"
        "/devices/L_P_D/transitions/1/when: state `A9` of `L_P_E` not found; did you mean `A1`?\n"
        "/devices/L_P_D/transitions/2/when: expected `and`, `or` or `)`, but the condition ends");
  const auto& all = list.evidence().faults;
  CHECK(all[0].column == 19);
  CHECK(all[2].column == 9);
}

TEST_CASE("A condition may name added states, and an error explains why a mere command or event is not a state") {
  DeviceDescription d = device();
  d.states = {"DOCK"};
  d.transitions = {transition("P1", "DOCK", "GO")};
  d.outputs = {{"P2", {{"BUSY", true}}, {}}};
  std::vector<std::string> names = kCell;
  names.push_back("L_P_D_O_GO");
  names.push_back("L_P_D_I_BUSY");
  DeviceDescription e = device("L_P_E");
  e.transitions = {transition("A1", "A2", "", "L_P_D.DOCK"), transition("A2", "A1", "", "L_P_D.go"),
                   automatic("A1", "A2", "not L_P_D.BUSY")};
  CHECK(faults(described(names, {d, e})) ==
        "/devices/L_P_E/transitions/1/when: `go` only commands given transitions and is not a state of `L_P_D`; name "
        "the symbol `L_P_D_O_GO`\n"
        "/devices/L_P_E/transitions/2/when: `BUSY` is only switched by `outputs` and is not a state of `L_P_D`; name "
        "the symbol `L_P_D_I_BUSY`");
}

TEST_CASE("A condition may name a symbol of no device, but no facet of a device with one unit") {
  DeviceDescription d = device();
  d.transitions = {transition("P1", "P2", "", "START and 'L_P_E'.A1"), transition("P2", "P1", "", "L_P_E.CLAMP.A1")};
  std::vector<Row> rows = bits(kCell);
  rows.push_back({"START", "X77"});
  CHECK(faults(analyse_described(rows, describing({d}))) ==
        "/devices/L_P_D/transitions/1/when: facet `CLAMP` of `L_P_E` not found");
}

// Disables.

TEST_CASE("Disabled units are listed by state, ascending and once") {
  DeviceDescription d = device("L_P_E");
  d.disables = {{"A2", {"L_P_F", "l_p_d", "L_P_F"}}};
  std::vector<std::string> names = kCell;
  names.push_back("L_P_F_O_ON");
  const Analysed list = described(names, {d});
  CHECK(faults(list) == "");
  const model::Unit& unit = unit_of(list, "L_P_E");
  REQUIRE(unit.disables.size() == 2);
  CHECK(unit.disables[0].empty());
  CHECK(unit.disables[1] == std::vector<std::uint32_t>{0, 2});
  CHECK(unit_of(list).disables.empty());
}

TEST_CASE("Units keep their indexes if a device before them is too large") {
  std::vector<std::string> names;
  for (int i = 0; i < 65; ++i) names.push_back("L_P_BIG_O_T" + std::to_string(i));
  names.insert(names.end(), kCell.begin(), kCell.end());
  DeviceDescription d = device();
  d.disables = {{"P1", {"L_P_E"}}};
  d.transitions = {transition("P1", "P2", "", "L_P_E.A1")};
  const Analysed list = described(names, {d});
  CHECK(faults(list) == "");
  CHECK(unit_of(list).disables[0] == std::vector<std::uint32_t>{1});
  CHECK(unit_of(list).conditions[0].atom.of == 1);
}

TEST_CASE("Disabling itself, an unknown device or state, and a duplicate state are faults") {
  DeviceDescription d = device();
  d.disables = {{"P1", {"L_P_D", "L_P_G"}}, {"P8", {"L_P_E"}}, {"p1", {}}};
  CHECK(faults(described(kCell, {d})) ==
        "/devices/L_P_D/disables/P1/0: `L_P_D` disables itself; remove it\n"
        "/devices/L_P_D/disables/P1/1: device `L_P_G` not found; did you mean `L_P_D`?\n"
        "/devices/L_P_D/disables/P8: state `P8` of `L_P_D` not found; did you mean `P1`?\n"
        "/devices/L_P_D/disables/p1: `p1` appears twice; merge both");
}

// Behaviours.

TEST_CASE("A behavior's inputs come after the transitions' conditions, by name, including equal texts") {
  DeviceDescription d = device();
  d.behaviour = "MyTable";
  d.transitions = {transition("P1", "P2", "", "L_P_E.A1")};
  d.inputs = {{"part", "L_P_E.A1"}, {"clear", "not L_P_E.moving"}};
  const Analysed list = described(kCell, {d});
  CHECK(faults(list) == "");
  CHECK(unit_of(list).conditions.size() == 3);
  CHECK(unit_of(list).first_input == 1);
  CHECK(unit_of(list).conditions[1].kind == Tree::Kind::negation);
  CHECK(unit_of(list).input_names == std::vector<std::string_view>{"clear", "part"});
}

TEST_CASE("Unused inputs are checked, and are no conditions") {
  DeviceDescription d = device();
  d.inputs = {{"part", "L_P_E.A1"}, {"clear", "L_P_E.X"}};
  const Analysed list = described(kCell, {d});
  CHECK(faults(list) == "/devices/L_P_D/inputs/clear: state `X` of `L_P_E` not found");
  CHECK(unit_of(list).conditions.empty());
}

TEST_CASE("A device has its numeric symbols as values, in list order, and a behavior sees them") {
  DeviceDescription d = device();
  d.behaviour = "MyTable";
  const Analysed list = analyse_described(cell_with_numbers(), describing({d}));
  CHECK(unit_of(list).values == std::vector<std::uint32_t>{8, 10});
  CHECK(unit_of(list).behaviour_values().size() == 2);
  CHECK_FALSE(unit_of(list, "L_P_E").values.empty());
  CHECK(unit_of(list, "L_P_E").behaviour_values().empty());
}

TEST_CASE("A device with a behavior counts as driving all its events") {
  DeviceDescription d = device("L_P_B");
  const std::vector<std::string> button = {"L_P_B_I_ON"};
  CHECK_FALSE(unit_of(described(button, {d}), "L_P_B").moves());
  d.behaviour = "Person";
  const Analysed list = described(button, {d});
  CHECK(unit_of(list, "L_P_B").moves());
  CHECK(unit_of(list, "L_P_B").moves_event(0));
  CHECK(unit_of(list, "L_P_B").reaches(1));
}

// Requirements.

description::GivenRequirement never(std::string name, std::string condition) {
  description::GivenRequirement given;
  given.name = std::move(name);
  given.never = std::move(condition);
  return given;
}

TEST_CASE("Requirements have their conditions resolved") {
  description::Description description;
  description.requirements = {never("apart", "L_P_D.P2 and L_P_E.A2"), {"answers", "", "L_P_D.P2", "L_P_E_I_A2", 500}};
  const Analysed list = analyse_described(bits(kCell), std::move(description));
  CHECK(faults(list) == "");
  const auto& requirements = list.model().requirements;
  REQUIRE(requirements.size() == 2);
  CHECK(requirements[0].name == "apart");
  CHECK(requirements[0].kind == tables::RequirementRow::Kind::never);
  CHECK(requirements[0].condition.kind == Tree::Kind::all);
  CHECK(requirements[1].kind == tables::RequirementRow::Kind::expect);
  CHECK(requirements[1].condition.atom.state == 1);
  CHECK(requirements[1].expected.atom.kind == Atom::Kind::bit);
  CHECK(requirements[1].within == 500);
}

TEST_CASE("A requirement without a unique name, or without its parts, is a fault") {
  description::Description description;
  description.requirements = {never("a", "L_P_D.P1"), never("a", "L_P_D.P2"),
                              never("", "L_P_D.P1"),  {"b", "", "L_P_D.P1", "", 0},
                              {"c", "", "", "", 0},   {"d", "L_P_D.P1", "", "L_P_D.P1", 0}};
  const std::string parts = ": a requirement needs either `never`, or `after` with `expect`";
  CHECK(faults(analyse_described(bits(kCell), std::move(description))) ==
        "/requirements/1/name: `a` already names another requirement; choose another name\n"
        "/requirements/2/name: this requirement has no name; give it one\n"
        "/requirements/3" +
            parts + "\n/requirements/4" + parts + "\n/requirements/5" + parts);
}

TEST_CASE("A requirement's conditions report all their faults") {
  description::Description description;
  description.requirements = {never("a", "L_P_D.P9"), {"b", "", "L_P_D_I_P", "L_P_D", 0}};
  CHECK(faults(analyse_described(bits(kCell), std::move(description))) ==
        "/requirements/0/never: state `P9` of `L_P_D` not found; did you mean `P1`?\n"
        "/requirements/1/after: symbol `L_P_D_I_P` not found; did you mean `L_P_D_I_P1`?\n"
        "/requirements/1/expect: `L_P_D` is a device; name one of its states, as in `L_P_D.STATE`");
}

}  // namespace
}  // namespace symplant::test
