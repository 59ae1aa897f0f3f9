// Units under a custom naming rule: facets, what plant.json says of them, and how conditions name them.
#include <string>
#include <utility>
#include <vector>

#include "model/condition_text.hpp"
#include "support/catch.hpp"
#include "support/compile.hpp"
#include "unit/model/description_support.hpp"
#include "unit/model/model_support.hpp"

namespace symplant::test {
namespace {

using model::InitialFrom;
using name::Account;

name::Naming cell() {
  name::Naming naming;
  naming.rules.emplace_back().patterns.push_back({name::Source::name, "{process}_{device}_{task...}"});
  naming.archetypes.push_back({"echo",
                               name::ArchetypeModel::mirror,
                               {{name::ArchetypeRole::operation, "{x}"}, {name::ArchetypeRole::event, "{x} ECHO"}}});
  return naming;
}

/// Rows with an address: those that begin with `Q ` are outputs, the others inputs; a `*` sets Initial TRUE.
std::vector<Row> cell_rows(const std::vector<std::string>& names) {
  std::vector<Row> rows;
  for (const std::string& name : names) {
    const std::string number = std::to_string(rows.size());
    const bool on = name.back() == '*';
    rows.push_back({name.substr(2, name.size() - (on ? 3 : 2)), "", "BOOL", on ? "TRUE" : "FALSE",
                    (name.front() == 'Q' ? "%QX" : "%IX") + number});
  }
  return rows;
}

Analysed analyse_cell(const std::vector<std::string>& names, description::Description description = {},
                      name::Naming naming = cell()) {
  return analyse_by_rule(std::move(naming), {{"list.csv", list_text(cell_rows(names))}}, std::move(description));
}

const std::vector<std::string> kRobot = {"Q S1_RB_ADV_SOL", "Q S1_RB_RET_SOL",   "I S1_RB_ADV_END",
                                         "I S1_RB_RET_END", "Q S1_RB_JOB_A",     "I S1_RB_JOB_A_ECHO",
                                         "Q S1_RB_JOB_B",   "I S1_RB_JOB_B_ECHO"};

std::string units(const Analysed& analysed) {
  std::string text;
  for (const model::Unit& unit : analysed.model().units) text.append(text.empty() ? "" : " ").append(unit.path);
  return text;
}

std::string warnings_of(const Analysed& analysed) {
  std::string text;
  for (const auto& fault : analysed.evidence().warnings) text += fault.pointer + ": warning: " + fault.message + "\n";
  return text;
}

TEST_CASE("Each facet of a device is a unit") {
  const Analysed list = analyse_cell(kRobot);
  CHECK(units(list) == "S1_RB S1_RB.echo_JOB_A S1_RB.echo_JOB_B");
  const model::Unit& moves = unit_of(list, "S1_RB");
  CHECK(moves.states[0].name == "RET");
  CHECK(moves.states[1].name == "ADV");
  CHECK(moves.initial == 0);
  CHECK(moves.initial_from == InitialFrom::naming);
  const model::Unit& echo = unit_of(list, "S1_RB.echo_JOB_A");
  CHECK(echo.device == "RB");
  CHECK(echo.device_path() == "S1_RB");
  CHECK(echo.initial_from == InitialFrom::naming);
  CHECK(echo.transitions.size() == 2);
  CHECK(list.fired(diag::Severity::warning).empty());
}

TEST_CASE("Symbols in no facet have the reason of the naming rule") {
  name::Naming naming = cell();
  naming.ignore = {"SPARE*"};
  name::SymbolRule lamps;
  lamps.patterns.push_back({name::Source::name, "LAMP_{device...}"});
  lamps.role = name::Role::operator_panel;
  naming.rules.insert(naming.rules.begin(), lamps);
  const Analysed list = analyse_cell(
      {"Q S1_RB_ADV_SOL", "I S1_RB_ADV_END", "I S1_RB_READY", "Q SPARE1", "Q X", "Q LAMP_A_B"}, {}, naming);
  std::vector<Account> reasons;
  for (const model::Symbol& symbol : list.model().symbols) reasons.push_back(symbol.account);
  // READY belongs to the unit, although nothing links it.
  CHECK(reasons == std::vector<Account>{Account::modelled, Account::modelled, Account::modelled, Account::ignored,
                                        Account::no_rule, Account::operator_panel});
  CHECK_FALSE(list.model().is_linked(2));
  CHECK(list.fired(diag::Severity::warning).empty());
}

TEST_CASE("The Initial column has priority over the rest position") {
  const Analysed list = analyse_cell({"Q S1_RB_ADV_SOL", "Q S1_RB_RET_SOL", "I S1_RB_ADV_END*", "I S1_RB_RET_END"});
  CHECK(unit_of(list, "S1_RB").initial == 1);
  CHECK(unit_of(list, "S1_RB").initial_from == InitialFrom::initial_column);
}

TEST_CASE("Digits are sequence numbers only if the naming rule says so") {
  const std::vector<std::string> rows = {"Q S1_MC_JOB2_SOL", "I S1_MC_JOB2_END", "I S1_MC_IDLE1"};
  const Analysed apart = analyse_cell(rows);
  CHECK(unit_of(apart, "S1_MC").states[0].name == "NOT_JOB2");
  name::Naming naming = cell();
  naming.tasks.sequence = true;
  const Analysed sequence = analyse_cell(rows, {}, naming);
  CHECK(unit_of(sequence, "S1_MC").states[0].name == "IDLE1");
  CHECK(unit_of(sequence, "S1_MC").transitions.back().origin == model::Origin::inferred);
}

TEST_CASE("An entry may name a facet, and wins key by key over the naming rule") {
  auto echo = device("s1_rb.ECHO_job_a");
  echo.initial = "ON";
  const Analysed list = analyse_cell(kRobot, describing({echo}));
  CHECK(faults(list).empty());
  const model::Unit& unit = unit_of(list, "S1_RB.echo_JOB_A");
  CHECK(unit.states[unit.initial].name == "ON");
  CHECK(unit.initial_from == InitialFrom::description);
  CHECK(unit.transitions.size() == 2);
  CHECK(unit_of(list, "S1_RB.echo_JOB_B").initial_from == InitialFrom::naming);
}

TEST_CASE(
    "An entry with a device's path is for the facet with the device's name, else for all facets that have it all") {
  auto robot = device("S1_RB");
  robot.actuation = tables::Actuation::held;
  const Analysed one = analyse_cell(kRobot, describing({robot}));
  CHECK(unit_of(one, "S1_RB").actuation == tables::Actuation::held);
  CHECK(unit_of(one, "S1_RB.echo_JOB_A").actuation == tables::Actuation::latched);

  const std::vector<std::string> two = {"Q S1_RB_ADV_SOL", "I S1_RB_ADV_END", "I S1_RB_RET_END",
                                        "Q S1_RB_UP_SOL",  "I S1_RB_UP_END",  "I S1_RB_DOWN_END"};
  auto up = device("S1_RB");
  description::GivenTransition lift;
  lift.from = "DOWN";
  lift.to = "UP";
  lift.takes = description::Duration::fixed(7);
  up.transitions.push_back(lift);
  const Analysed all = analyse_cell(two, describing({up}));
  CHECK(units(all) == "S1_RB.RET_ADV S1_RB.DOWN_UP");
  CHECK(unit_of(all, "S1_RB.DOWN_UP").transitions[0].takes.a == 7);
  CHECK(all.evidence().faults.empty());
  CHECK(warnings_of(all).find("1 of the 2 devices that take this entry from `S1_RB` has no state `DOWN`") !=
        std::string::npos);
}

TEST_CASE("A pattern matches the path of a facet, and that of its device") {
  auto echoes = device("S?_RB.echo*");
  echoes.initial = "ON";
  const Analysed list = analyse_cell(kRobot, describing({echoes}));
  CHECK(unit_of(list, "S1_RB.echo_JOB_A").initial_from == InitialFrom::description);
  CHECK(unit_of(list, "S1_RB.echo_JOB_B").initial_from == InitialFrom::description);
  CHECK(unit_of(list, "S1_RB").initial_from == InitialFrom::naming);
  auto robots = device("*_RB");
  robots.actuation = tables::Actuation::latched;
  const Analysed all = analyse_cell(kRobot, describing({robots}));
  CHECK(all.evidence().decisions == std::vector<std::string>{"`*_RB` matches 3 devices"});
}

TEST_CASE("An entry of times is for the unit of that path, else for all units of the device") {
  const auto timed = [](const std::string& device) {
    description::Description description;
    description.times.push_back(
        {device,
         {{"ON->OFF", {"ON", "OFF"}, {}, Duration::fixed(7)}, {"OFF->ON", {"OFF", "ON"}, {}, Duration::fixed(8)}}});
    return analyse_cell(kRobot, description);
  };
  const Analysed one = timed("s1_rb.echo_job_a");
  CHECK(faults(one) == "");
  CHECK(unit_of(one, "S1_RB.echo_JOB_A").transitions.at(0).takes.a +
            unit_of(one, "S1_RB.echo_JOB_A").transitions.at(1).takes.a ==
        15);
  CHECK(unit_of(one, "S1_RB.echo_JOB_B").transitions.at(0).takes.a == 0);
  const std::vector<std::string> jobs(kRobot.begin() + 4, kRobot.end());
  description::Description description;
  description.times.push_back({"S1_RB", {{"ON->OFF", {"ON", "OFF"}, {}, Duration::fixed(7)}}});
  const Analysed both = analyse_cell(jobs, description);
  CHECK(faults(both) == "");
  CHECK(both.evidence().decisions.empty());
  for (const char* path : {"S1_RB.echo_JOB_A", "S1_RB.echo_JOB_B"}) {
    const auto& transitions = unit_of(both, path).transitions;
    CHECK(std::any_of(transitions.begin(), transitions.end(), [](const auto& t) { return t.takes.a == 7; }));
  }
}

TEST_CASE("An entry that contradicts the naming rule is an error at the entry") {
  auto echo = device("S1_RB.echo_JOB_A");
  echo.states = {"OTHER"};
  const Analysed list = analyse_cell(kRobot, describing({echo}));
  CHECK(faults(list).starts_with("/devices/S1_RB.echo_JOB_A: state `OFF` of `S1_RB.echo_JOB_A` not found"));
}

TEST_CASE("Another actuation leaves the spring of the naming rule") {
  auto pin = device("S1_PIN");
  pin.actuation = tables::Actuation::held;
  const Analysed list = analyse_cell({"Q S1_PIN_DOWN_SOL", "I S1_PIN_UP_END"}, describing({pin}));
  CHECK(faults(list).empty());
  CHECK(unit_of(list, "S1_PIN").actuation == tables::Actuation::held);
}

std::string condition_fault(const std::string& text) {
  description::Description description;
  description.requirements.push_back({"r", text, {}, {}, 0});
  const Analysed list = analyse_cell(kRobot, description);
  if (!list.model().requirements.empty()) {
    return model::condition_text(list.model().requirements[0].condition, list.model());
  }
  return list.evidence().faults.front().message;
}

TEST_CASE("Conditions find a state in the facet that has it, and name the facet if several have it") {
  CHECK(condition_fault("S1_RB.ADV") == "S1_RB.ADV");
  CHECK(condition_fault("S1_RB.echo_JOB_A.ON") == "S1_RB.echo_JOB_A.ON");
  CHECK(condition_fault("S1_RB.echo_JOB_A.moving") == "S1_RB.echo_JOB_A.moving");
  CHECK(condition_fault("S1_RB.moving") == "S1_RB.moving");
  CHECK(condition_fault("S1_RB.ON") ==
        "`S1_RB.ON` is in several facets of the device; write `S1_RB.echo_JOB_A.ON`, `S1_RB.echo_JOB_B.ON`");
  CHECK(condition_fault("S1_RB.ADW") == "state `ADW` of `S1_RB` not found; did you mean `ADV`?");
  CHECK(condition_fault("S1_RB.echo_JOB_C.ON") ==
        "facet `echo_JOB_C` of `S1_RB` not found; did you mean `S1_RB.echo_JOB_A`?");
}

TEST_CASE("Disabling a device disables all its facets") {
  std::vector<std::string> rows = kRobot;
  rows.insert(rows.end(), {"Q S1_DOOR_OPEN_SOL", "I S1_DOOR_OPEN_END", "I S1_DOOR_CLOSE_END"});
  auto door = device("S1_DOOR");
  door.disables.push_back({"OPEN", {"S1_RB"}});
  const Analysed list = analyse_cell(rows, describing({door}));
  CHECK(faults(list).empty());
  const model::Unit& unit = unit_of(list, "S1_DOOR");
  CHECK(unit.disables[1] == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("Constants have their value from the start") {
  name::Naming naming = cell();
  name::SymbolRule normal;
  normal.patterns.push_back({name::Source::name, "{device...}_NORMAL"});
  normal.role = name::Role::constant;
  naming.rules.insert(naming.rules.begin(), normal);
  const Analysed list = analyse_cell({"I AIR_NORMAL", "Q S1_RB_ADV_SOL", "I S1_RB_ADV_END"}, {}, naming);
  CHECK(list.model().symbols[0].account == Account::constant);
  CHECK(list.model().symbols[0].initial == 1);
}

TEST_CASE("Two devices of one path, and two symbols of one role, are warnings") {
  name::Naming naming = cell();
  naming.separators = " -";
  naming.rules[0].patterns[0].pattern = "{process}-{device}-{task...}";
  naming.archetypes[0].texts[1].second = "{x}ECHO|{x}SEEN";
  const Analysed list =
      analyse_cell({"Q A_B-C-ADV-SOL", "I A_B-C-ADV-END", "Q A-B_C-ADV-SOL", "I A-B_C-ADV-END"}, {}, naming);
  CHECK(list.count("naming-ambiguous") == 1);
  naming = cell();
  naming.archetypes[0].texts[1].second = "{x} ECHO|{x} SEEN";
  const Analysed roles = analyse_cell({"Q S1_RB_GO", "I S1_RB_GO_ECHO", "I S1_RB_GO_SEEN"}, {}, naming);
  CHECK(roles.count("naming-ambiguous") == 1);
}

TEST_CASE("An event of several states is on in each of them") {
  name::Naming naming = cell();
  naming.links = {{"KA1", "B1", "UP"}, {"KA2", "B1", "MIDDLE"}, {"", "B2", "DOWN"}};
  naming.links[1].operation.clear();
  const Analysed list = analyse_cell({"Q KA1", "I B1", "I B2"}, {}, naming);
  CHECK(faults(list).empty());
  const model::Unit& unit = unit_of(list, "KA1");
  CHECK(states_text(unit) == "UP MIDDLE DOWN");
  CHECK(unit.outputs[1].enter == std::vector<std::pair<std::uint32_t, bool>>{{0, true}});
}

TEST_CASE("A list without pairs says why") {
  const Analysed list = analyse_cell({"I S1_RB_ADV_END", "I S1_RB_READY", "I XYZ"});
  CHECK(list.count("no-device") == 1);
  CHECK(std::string(list.diagnostics.all().front().message)
            .find("1 matched by no pattern, 2 not paired; correct the rule") != std::string::npos);
}

TEST_CASE("Names in braces are levels of the naming rule, and a level that it lacks is an error") {
  description::Description description;
  description.requirements = {{"{self} of {process} {device} {1}", "{self}.ADV", "", "", 0, "*"}};
  const Analysed list = analyse_cell(kRobot, description);
  CHECK(faults(list) == "");
  REQUIRE(list.model().requirements.size() == 1);  // one for the device, not for each facet
  CHECK(list.model().requirements.front().name == "S1_RB of S1 RB S1_RB");
  const std::vector<std::string> facets_only(kRobot.begin() + 4, kRobot.end());
  description.requirements = {{"{self} {1}", "{self}.echo_JOB_A.moving", "", "", 0, "*"}};
  const Analysed facets = analyse_cell(facets_only, description);
  CHECK(faults(facets) == "");
  REQUIRE(facets.model().requirements.size() == 1);
  CHECK(facets.model().requirements.front().name == "S1_RB S1_RB");
  description.requirements.front().name = "{line} {self}";
  CHECK(faults(analyse_cell(kRobot, description)) ==
        "/requirements/0/name: `{line}` is unknown here; use one of `{process}`, `{device}`, `{self}`, `{1}`");
}

TEST_CASE("Wildcards match parts of the device's name, also for its facets") {
  std::vector<std::string> rows = kRobot;
  rows.insert(rows.end(), {"Q S2_RB_ADV_SOL", "I S2_RB_ADV_END", "Q S2_RB_RET_SOL", "I S2_RB_RET_END"});
  const auto conditions = [&](std::string pattern, std::string when) {
    DeviceDescription d = device(std::move(pattern));
    d.transitions = {transition("RET", "ADV", "", std::move(when))};
    const Analysed list = analyse_cell(rows, describing({d}));
    CHECK(faults(list) == "");
    const model::Unit& unit = unit_of(list, "S1_RB");
    return unit.conditions.empty() ? "" : model::condition_text(unit.conditions.front(), list.model());
  };
  CHECK(conditions("S1_*", "S2_{1}.ADV") == "S2_RB.ADV");
  CHECK(conditions("S?_RB", "S2_RB.ADV and S{1}_RB.moving") == "S2_RB.ADV and S1_RB.moving");
}

TEST_CASE("A sensor of parts is in no facet, and `for` matches the devices of the custom rule") {
  std::vector<std::string> names = kRobot;
  for (const std::string name : {"I S1_RB_PART*", "Q S2_RB_ADV_SOL", "I S2_RB_ADV_END", "I S2_RB_PART"}) {
    names.push_back(name);
  }
  description::Description description;
  description.material.kinds = {{"raw", 1000, 0}};
  description.material.places = {{"{self}_P", "S?_RB", 1, {}}};
  description.material.places[0].sensors.emplace_back().symbol = "{process}_{device}_PART";
  const Analysed list = analyse_cell(names, description);
  CHECK(faults(list) == "");
  CHECK(warnings_of(list) == "");
  const std::vector<model::Place>& places = list.model().material.places;
  REQUIRE(places.size() == 2);
  CHECK(places[1].name == "S2_RB_P");
  for (const std::string name : {"S1_RB_PART", "S2_RB_PART"}) {
    CHECK(symbol_of(list, name).account == Account::senses_parts);
    CHECK(symbol_of(list, name).unit == model::kNone);
  }
  CHECK(units(list) == units(analyse_cell({names.begin(), names.begin() + 8})) + " S2_RB");
}

}  // namespace
}  // namespace symplant::test
