// naming.json: what is read from it, and what is rejected.
#include "naming/naming_file.hpp"

#include <string>

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using name::Direction;
using name::Evidence;
using naming::NamingReading;
using Words = std::vector<name::DirectionWord>;
using Texts = std::vector<std::string>;
using Pairs = std::vector<std::pair<std::string, std::string>>;

constexpr std::string_view kRules = R"("rules": [{"pattern": "{device}_{task}"}])";

NamingReading read(const std::string& members) {
  return naming::read_naming("{\"symplant-naming\": 1" + (members.empty() ? "" : ", " + members) + "}");
}

/// All faults: "pointer: message", one per line.
std::string faults_of(const NamingReading& reading) {
  std::string text;
  for (const json::Placed& fault : reading.syntax) text += "syntax: " + fault.message + "\n";
  for (const auto& fault : reading.faults) text += fault.pointer + ": " + fault.message + "\n";
  if (!text.empty()) text.pop_back();
  return text;
}

std::string faults_of(const std::string& members) { return faults_of(read(members)); }

name::Naming sound(const std::string& members) {
  NamingReading reading = read(members);
  INFO(members);
  CHECK(faults_of(reading) == "");
  REQUIRE(reading.naming);
  return std::move(*reading.naming);
}

name::Naming with_rules(const std::string& members) { return sound(std::string(kRules) + ", " + members); }

std::string faults_with_rules(const std::string& members) { return faults_of(std::string(kRules) + ", " + members); }

name::SymbolRule rule(const std::string& members) {
  name::Naming naming = sound("\"rules\": [{" + members + "}]");
  REQUIRE(naming.rules.size() == 1);
  return std::move(naming.rules.front());
}

std::string rule_faults(const std::string& members) { return faults_of("\"rules\": [{" + members + "}]"); }

name::Archetype archetype(const std::string& members) {
  name::Naming naming = with_rules("\"archetypes\": [{\"name\": \"a\", " + members + "}]");
  REQUIRE(naming.archetypes.size() == 1);
  return std::move(naming.archetypes.front());
}

std::string archetype_faults(const std::string& members) {
  return faults_with_rules("\"archetypes\": [{\"name\": \"a\", " + members + "}]");
}

TEST_CASE("A naming rule without other keys has the defaults") {
  const name::Naming naming = sound(std::string(kRules));
  const name::Naming defaults;
  CHECK(naming.separators == defaults.separators);
  CHECK(naming.normalise.collapse);
  CHECK_FALSE(naming.normalise.camel_case);
  CHECK(naming.direction.evidence == defaults.direction.evidence);
  CHECK(naming.tasks.vocabulary);
  CHECK(naming.tasks.sensor_index == name::SensorIndex::on);
  CHECK_FALSE(naming.tasks.sequence);
  REQUIRE(naming.rules.size() == 1);
  CHECK(naming.rules[0].role == name::Role::io);
  CHECK(naming.rules[0].patterns[0].source == name::Source::name_then_comment);
}

TEST_CASE("Texts are normalised as `normalise`, `separators` and `ignore` say") {
  const name::Naming naming = with_rules(
      R"("name": "n", "normalise": {"collapse": false, "line-break": "$N", "columns": 8, "camel-case": true,
         "replace": [["W/MILL", "W/M"], ["A(B)?", "$1"]]}, "separators": " _-", "ignore": ["SPARE*", "예비*"])");
  CHECK(naming.name == "n");
  CHECK_FALSE(naming.normalise.collapse);
  CHECK(naming.normalise.line_break == "$N");
  CHECK(naming.normalise.columns == 8);
  CHECK(naming.normalise.camel_case);
  REQUIRE(naming.normalise.replace.size() == 2);
  CHECK(naming.normalise.replace[1].expression == "A(B)?");
  CHECK(naming.normalise.replace[1].replacement == "$1");
  CHECK(naming.separators == " _-");
  CHECK(naming.ignore == Texts{"SPARE*", "예비*"});
}

TEST_CASE("A rule has one pattern, or one for each source") {
  CHECK(rule(R"("pattern": "{device}", "source": "comment")").patterns[0].source == name::Source::comment);
  const name::SymbolRule both = rule(R"("pattern": {"parent+comment": "{task}", "name": "{device}"})");
  REQUIRE(both.patterns.size() == 2);
  CHECK(both.patterns[0].source == name::Source::name);
  CHECK(both.patterns[0].pattern == "{device}");
  CHECK(both.patterns[1].source == name::Source::parent_and_comment);
  CHECK(rule_faults(R"("pattern": {"name": "{device}"}, "source": "name")") ==
        "/rules/0/source: `pattern` names the sources already; remove `source`");
  CHECK(rule_faults(R"("pattern": {})") ==
        "/rules/0/pattern: `pattern` names no source; give it a pattern for `name`, `comment` or `parent+comment`");
  CHECK(rule_faults(R"("pattern": {"commment": "{device}"})") ==
        "/rules/0/pattern/commment: the key `commment` is unknown here; did you mean `comment`?");
}

TEST_CASE("A field holds a regular expression, or words that each say a side") {
  const name::SymbolRule one = rule(R"("pattern": "{device}_{direction}_{class}", "fields": {"device": "RBT?[0-9]+",
      "direction": {"I": "event", "M": "internal", "Q": "operation"}}, "classes": {"SOL": "operation"})");
  REQUIRE(one.fields.size() == 2);
  CHECK(one.fields[0].field == "device");
  CHECK(one.fields[0].expression == "RBT?[0-9]+");
  CHECK(one.fields[1].words == Words{{"I", Direction::event}, {"M", std::nullopt}, {"Q", Direction::operation}});
  CHECK(one.classes == Words{{"SOL", Direction::operation}});
  CHECK(rule(R"("pattern": "{class}", "fields": {"class": {"LS": "event"}})").classes ==
        Words{{"LS", Direction::event}});
  CHECK(rule_faults(R"("pattern": "{device}", "fields": {"direction": {"I": "input"}})") ==
        "/rules/0/fields/direction/I: expected one of `event`, `operation`, `internal`, but found the text `input`");
  CHECK(rule_faults(R"("pattern": "{class}", "fields": {"class": {"LS": "event"}}, "classes": {"SOL": "operation"})") ==
        "/rules/0/classes: `fields` gives the words of `class` already; remove one of the two");
  CHECK(rule_faults(R"("pattern": "{device}", "classes": {"SOL": "operation"})") ==
        "/rules/0/classes: the pattern has no field `{class}`; add it to the pattern, or remove this");
  CHECK(rule_faults(R"("pattern": "{device}", "fields": {"devise": "A"})") ==
        "/rules/0/fields/devise: the key `devise` is unknown here; did you mean `device`?");
}

TEST_CASE("A rule may fix the task, restrict the side, fan out, replace texts, and account for symbols by a role") {
  const name::SymbolRule valve =
      rule(R"("name": "valves", "side": "operation", "pattern": "{device}", "task": "OPN", "fan-out": true,
              "replace": [["-", ""]])");
  CHECK(valve.name == "valves");
  CHECK(valve.side == Direction::operation);
  CHECK(valve.task == "OPN");
  CHECK(valve.fan_out);
  CHECK(valve.replace.size() == 1);
  CHECK(rule(R"("pattern": "{device}", "role": "operator")").role == name::Role::operator_panel);
  CHECK(rule(R"("pattern": "{device}", "role": "data")").role == name::Role::data);
  CHECK(rule(R"("pattern": "{device}", "role": "none")").role == name::Role::none);
  const name::SymbolRule constant = rule(R"("pattern": "{device}", "role": "constant", "value": true)");
  CHECK(constant.role == name::Role::constant);
  CHECK(constant.value == true);
}

TEST_CASE("Keys of a rule that contradict each other are faults") {
  CHECK(rule_faults(R"("pattern": "{device}_{task:known...}", "task": "ON")") ==
        "/rules/0/task: the pattern has the field `{task}`, so the task is not fixed; remove one of the two");
  CHECK(rule_faults(R"("pattern": "{device}", "value": true)") ==
        "/rules/0/value: only rules with `\"role\": \"constant\"` have a value; remove it, or add the role");
  CHECK(rule_faults(R"("pattern": "{device}", "role": "data", "fan-out": true)") ==
        "/rules/0/fan-out: symbols of the role `data` are never linked; remove `fan-out` or `role`");
}

TEST_CASE("Fixed levels are kept with their level") {
  const name::Naming naming = with_rules(R"("fixed": {"process": "S1", "line": "BB"})");
  REQUIRE(naming.fixed.size() == 2);
  CHECK(naming.fixed[0] == std::pair(name::Level::line, std::string("BB")));
  CHECK(naming.fixed[1] == std::pair(name::Level::process, std::string("S1")));
}

TEST_CASE("On a conflict the first evidence decides, the address, or none") {
  const auto field_first = with_rules(R"("direction": {"evidence": ["field", "address"]})").direction;
  CHECK(field_first.evidence == std::vector{Evidence::field, Evidence::address});
  const auto address = with_rules(R"("direction": {"evidence": ["class", "address", "prefix"],
                                     "on-conflict": "address"})")
                           .direction;
  CHECK(address.evidence == std::vector{Evidence::address, Evidence::klass, Evidence::prefix});
  CHECK_FALSE(address.conflict_is_error);
  CHECK(with_rules(R"("direction": {"on-conflict": "error"})").direction.conflict_is_error);
  CHECK(faults_with_rules(R"("direction": {"evidence": ["field"], "on-conflict": "address"})") ==
        "/direction/on-conflict: `evidence` does not list `address`, so it cannot decide; add it, or remove "
        "`on-conflict`");
}

TEST_CASE("Tasks have pairs, affixes, synonyms, sensor indexes and sequence numbers") {
  const name::TaskRules tasks = with_rules(R"("tasks": {"vocabulary": false, "pairs": [["RET", "ADV"]],
      "affixes": {"operation": ["SOL"], "event": ["END", "단"]}, "synonyms": {"FWD": "ADV"},
      "sensor-index": "appended", "sequence": true})")
                                    .tasks;
  CHECK_FALSE(tasks.vocabulary);
  CHECK(tasks.pairs == Pairs{{"RET", "ADV"}});
  CHECK(tasks.operation_affixes == Texts{"SOL"});
  CHECK(tasks.event_affixes == Texts{"END", "단"});
  CHECK(tasks.synonyms == Pairs{{"FWD", "ADV"}});
  CHECK(tasks.sensor_index == name::SensorIndex::appended);
  CHECK(tasks.sequence);
  CHECK(with_rules(R"("tasks": {"sensor-index": true})").tasks.sensor_index == name::SensorIndex::on);
  CHECK(with_rules(R"("tasks": {"sensor-index": false})").tasks.sensor_index == name::SensorIndex::off);
  CHECK(faults_with_rules(R"("tasks": {"sensor-index": "apended"})") ==
        "/tasks/sensor-index: expected one of `true`, `false`, `appended`, but found the text `apended`; did you mean "
        "`appended`?");
  CHECK(faults_with_rules(R"("tasks": {"pairs": [["RET"]]})") ==
        "/tasks/pairs/0: expected a pair of words, the rest position first, but found an array of too few items");
}

TEST_CASE("Links are the path of a file, or rows") {
  CHECK(read(std::string(kRules) + R"(, "links": "links.csv")").links_file == "links.csv");
  const name::Naming naming = with_rules(R"("links": [["O1", "E1", "ADV"], ["", "E2", "ADV"]])");
  REQUIRE(naming.links.size() == 2);
  CHECK(naming.links[0].operation == "O1");
  CHECK(naming.links[1].event == "E2");
  CHECK(naming.links[1].state == "ADV");
  CHECK(faults_with_rules(R"("links": [["", "E1", "ADV"]])") ==
        "/links/0: the first row has no operation; an empty operation continues the row above");
  CHECK(faults_with_rules(R"("links": [["O1", "E1"]])") ==
        "/links/0: expected a row of operation, event and state, but found an array of too few items\n"
        "/links/0: the row has no state; write the state that the operation leads to");
}

TEST_CASE("Archetypes have roles and settings of their models") {
  const name::Archetype echo =
      archetype(R"("model": "mirror", "operation": "{x}", "event": "{x} ECHO", "delay": "50ms", "inverted": true)");
  CHECK(echo.name == "a");
  CHECK(echo.model == name::ArchetypeModel::mirror);
  REQUIRE(echo.texts.size() == 2);
  CHECK(echo.texts[1] == std::pair(name::ArchetypeRole::event, std::string("{x} ECHO")));
  CHECK(echo.delay == 50'000'000);
  CHECK(echo.inverted);
  CHECK(archetype(R"("model": "handshake", "start": "A", "done": "B", "takes": "3s")").takes == 3'000'000'000);
  CHECK_FALSE(archetype(R"("model": "constant", "event": "*E STOP*|DOOR*", "value": false)").value);
  CHECK(archetype(R"("model": "two-position", "a": "A", "at_b": "B")").model == name::ArchetypeModel::two_position);
  CHECK(archetype(R"("model": "contactor", "on": "A", "is_on": "B")").model == name::ArchetypeModel::contactor);
}

TEST_CASE("Archetypes with unknown or missing roles are faults that name the known ones") {
  CHECK(archetype_faults(R"("model": "handshake", "start": "A")") ==
        "/archetypes/0/model: the model `handshake` needs the role `busy` or `done`; add it");
  CHECK(archetype_faults(R"("model": "mirror", "operation": "A", "event": "B", "start": "C")") ==
        "/archetypes/0/start: the model `mirror` has no role `start`; its roles are `operation`, `event`");
  CHECK(archetype_faults(R"("model": "constant", "event": "B", "takes": "3s")") ==
        "/archetypes/0/takes: `takes` has no effect on the model `constant`; remove it");
  CHECK(archetype_faults(R"("model": "mirror", "operation": "A", "evnt": "B")") ==
        "/archetypes/0/evnt: the key `evnt` is unknown here; did you mean `event`?\n"
        "/archetypes/0/model: the model `mirror` needs the role `event`; add it");
  CHECK(archetype_faults(R"("model": "relay", "operation": "A", "event": "B", "to": "partner")") ==
        "/archetypes/0/model: the model `relay` is not supported by this version of symplant; remove the archetype");
  const NamingReading twice = read(std::string(kRules) + R"(, "archetypes": [
      {"name": "a", "model": "constant", "event": "A"}, {"name": "a", "model": "constant", "event": "B"}])");
  CHECK(faults_of(twice) == "/archetypes/1/name: `a` is the name of two archetypes; rename one of them");
  CHECK(twice.faults[0].related == "/archetypes/0/name");
}

TEST_CASE("Unknown keys, missing keys and repeated keys are faults") {
  CHECK(faults_with_rules(R"("normalize": {})") ==
        "/normalize: the key `normalize` is unknown here; did you mean "
        "`normalise`?");
  CHECK(faults_of("") == ": the key `rules` is missing here; it holds an array of 1 to 1000 rules");
  CHECK(faults_of(R"("rules": [])") == "/rules: expected an array of 1 to 1000 rules, but found an empty array");
  CHECK(faults_with_rules(R"("name": "a", "name": "b")").starts_with("syntax: "));
  CHECK(with_rules("// a comment\n \"$schema\": \"naming.schema.json\"").rules.size() == 1);
}

TEST_CASE("Other files are recognized") {
  const auto refused = [](std::string_view text) {
    const NamingReading reading = naming::read_naming(text);
    CHECK_FALSE(reading.naming);
    return faults_of(reading);
  };
  CHECK(refused(R"({"symplant": 1})") == "/symplant: this is a plant description, not a naming rule; give it as PLANT");
  CHECK(refused("[1]") ==
        ": this is not an object; a naming rule is an object with `\"symplant-naming\": 1` and `rules`");
  CHECK(refused("{}") == ": this is JSON, but not a naming rule, which has `\"symplant-naming\": 1` and `rules`");
  CHECK(refused(R"({"symplant-naming": 2})") ==
        "/symplant-naming: this is version 2 of the format, but this symplant reads version 1; use a newer symplant");
  CHECK(refused("{").starts_with("syntax: "));
}

TEST_CASE("In another file the version may be missing, and pointers begin with the rule's") {
  const NamingReading reading =
      naming::read_inline_naming(R"({"rules": [{"pattern": "{device}", "tsk": "ON"}]})", "/naming");
  CHECK(faults_of(reading) == "/naming/rules/0/tsk: the key `tsk` is unknown here; did you mean `task`?");
  CHECK(faults_of(naming::read_inline_naming("{}", "/naming")) ==
        "/naming: the key `rules` is missing here; it holds an array of 1 to 1000 rules");
}

}  // namespace
}  // namespace symplant::test
