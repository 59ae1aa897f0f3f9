// Symbols read by rules of naming.json: patterns, directions, tasks.
#include "name/symbol_reader.hpp"

#include <deque>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "support/catch.hpp"

namespace symplant::name {
namespace {

std::unique_ptr<SymbolReader> reader_of(Naming naming) {
  std::vector<NamingFault> faults;
  auto compiled = CompiledNaming::compile(std::move(naming), faults);
  for (const NamingFault& fault : faults) UNSCOPED_INFO(fault.pointer << ": " << fault.message);
  REQUIRE(compiled != nullptr);
  return std::make_unique<SymbolReader>(compiled);
}

SymbolRule rule_of(std::string pattern) {
  SymbolRule rule;
  rule.patterns.push_back({Source::name_then_comment, std::move(pattern)});
  return rule;
}

Naming naming_of(std::string pattern) {
  Naming naming;
  naming.rules.push_back(rule_of(std::move(pattern)));
  return naming;
}

/// "line|process|device|side|canonical task" of a name.
std::string parts(const Reading& reading) {
  if (reading.account == Account::no_rule) return "no rule";
  if (reading.account == Account::ignored) return "ignored";
  std::string side = "-";
  if (reading.account == Account::named_internal) side = "internal";
  if (reading.direction) side = *reading.direction == Direction::event ? "event" : "operation";
  return std::string(reading.levels->line) + "|" + std::string(reading.levels->process) + "|" +
         std::string(reading.levels->device) + "|" + side + "|" + std::string(reading.task->canonical);
}

std::string read(SymbolReader& reader, std::string_view name) { return parts(reader.read({name, {}, {}, {}})); }

TEST_CASE("A field is one word, a field with dots any number, the last motion the task") {
  const auto reader = reader_of(naming_of("{process}_{class}_{device...}_{task:known}"));
  CHECK(read(*reader, "S205_SOL_CLAMP1_ADV") == "|S205|CLAMP1|operation|ADV");
  CHECK(read(*reader, "S205_WRS_CLAMP1_ADV1") == "|S205|CLAMP1|event|ADV");
  CHECK(read(*reader, "S205_SOL_1ST_CLAMP1_RET") == "|S205|1ST_CLAMP1|operation|RET");
  CHECK(read(*reader, "S205_SOL_CLAMP1_WELD") == "no rule");
  CHECK(read(*reader, "S205_LS_LOCK_CLAMP_ADV_END_2") == "|S205|LOCK_CLAMP|event|ADV");
  CHECK(read(*reader, "S205_ZZZ_CLAMP1_ADV") == "no rule");
}

TEST_CASE("The device may follow its task") {
  const auto reader = reader_of(naming_of("{process}_{class}_{task:known}_{device...}"));
  CHECK(read(*reader, "S301LH_SOL_ADV_LOCK_CLAMP") == "|S301LH|LOCK_CLAMP|operation|ADV");
  CHECK(read(*reader, "S301LH_LS_ADV_LOCK_CLAMP1") == "|S301LH|LOCK_CLAMP1|event|ADV");
}

TEST_CASE("Runs of separators count as one, and those at the ends as none") {
  const auto reader = reader_of(naming_of("{process}_{direction}_{device}_{task...}"));
  CHECK(read(*reader, "S334_X_ RBT1  IN  OK _") == "|S334|RBT1|event|IN OK");
}

TEST_CASE("Groups hold alternatives, of several words and empty ones too") {
  const auto reader = reader_of(naming_of("{process}(LH|RH|)_{device...}_(PB|PB_LAMP|SW)_{task}"));
  CHECK(read(*reader, "S1LH_DESK_PB_START") == "|S1|DESK|-|START");
  CHECK(read(*reader, "S1_DESK_PB_LAMP_START") == "|S1|DESK|-|START");
  CHECK(read(*reader, "S1_DESK_KEY_START") == "no rule");
}

TEST_CASE("A fused direction is compared with its case, and is not the begin of a word") {
  Naming naming = naming_of("{direction}{device}_{task...}");
  naming.rules[0].fields.push_back({"direction", "", {{"i", Direction::event}, {"q", Direction::operation}}});
  const auto reader = reader_of(naming);
  CHECK(read(*reader, "iConv5_prdSens") == "||Conv5|event|prdSens");
  CHECK(read(*reader, "qConv1_13Fwd") == "||Conv1|operation|13Fwd");
  CHECK(read(*reader, "IConv5_prdSens") == "no rule");
  CHECK(read(*reader, "indicator_on") == "no rule");
}

TEST_CASE("The address decides the side unless the evidence has another order") {
  Naming naming = naming_of("{process}_{direction}_{device}_{task...}");
  {
    const auto reader = reader_of(naming);
    const Reading reading = reader->read({"S1_I_RB1_ECHO", {}, {}, Direction::operation});
    CHECK(reading.direction == Direction::operation);
    CHECK(reading.direction_by == Evidence::address);
    CHECK(reading.direction_of_name == Direction::event);
  }
  naming.direction.evidence = {Evidence::field, Evidence::address};
  const auto reader = reader_of(naming);
  CHECK(reader->read({"S1_I_RB1_ECHO", {}, {}, Direction::operation}).direction == Direction::event);
}

TEST_CASE("A rule may take one field from the name and another from the comment") {
  Naming naming;
  SymbolRule rule;
  rule.patterns = {{Source::name, "{device...}"}, {Source::comment, "{class}_{task:known}"}};
  naming.rules.push_back(rule);
  const auto reader = reader_of(naming);
  CHECK(parts(reader->read({"KA12", "SOL ADV", {}, {}})) == "||KA12|operation|ADV");
  CHECK(parts(reader->read({"KA12", "spare", {}, {}})) == "no rule");
}

TEST_CASE("The comment of a word comes before that of its bit") {
  Naming naming;
  SymbolRule rule;
  rule.patterns = {{Source::parent_and_comment, "{process}_{device}_{task...}"}};
  naming.rules.push_back(rule);
  naming.normalise.line_break = "$N";
  const auto reader = reader_of(naming);
  CHECK(parts(reader->read({"I0", "PART$NOK", "S10 RB1", Direction::event})) == "|S10|RB1|event|PART OK");
}

TEST_CASE("Affixes say the side only, and synonyms are one word") {
  Naming naming = naming_of("{process}_{device}_{task...}");
  naming.tasks.synonyms = {{"VOR", "ADV"}, {"FULL STROKE", "STROKED"}};
  naming.tasks.event_affixes = {"OKAY"};
  const auto reader = reader_of(naming);
  CHECK(parts(reader->read({"S1_A_VOR_OKAY", {}, {}, Direction::event})) == "|S1|A|event|ADV");
  CHECK(parts(reader->read({"S1_A_VOR_OKAY", {}, {}, Direction::operation})) == "|S1|A|operation|ADV OKAY");
  CHECK(parts(reader->read({"S1_A_FULL_STROKE", {}, {}, Direction::event})) == "|S1|A|event|STROKED");
}

TEST_CASE("The number of a sensor is off the canonical task and kept apart") {
  const auto reader = reader_of(naming_of("{process}_{device}_{task...}"));
  const Reading event = reader->read({"S1_A_ADV2", {}, {}, Direction::event});
  CHECK(event.task->canonical == "ADV");
  CHECK(event.task->index == "2");
  const Reading operation = reader->read({"S1_A_RET", {}, {}, Direction::operation});
  CHECK(operation.task->group == event.task->group);
  CHECK(operation.task->rest);
  CHECK_FALSE(event.task->rest);
  CHECK(reader->read({"S1_A_ADV_2", {}, {}, Direction::event}).task->canonical == "ADV");
}

TEST_CASE("Words in Cyrillic are one device in any case") {
  const auto reader = reader_of(naming_of("{device}_{task...}"));
  CHECK(reader->read({"Захват_ADV", {}, {}, {}}).levels->device_id ==
        reader->read({"захват_RET", {}, {}, {}}).levels->device_id);
  CHECK(reader->read({"Стол_ADV", {}, {}, {}}).levels->device_id !=
        reader->read({"захват_RET", {}, {}, {}}).levels->device_id);
}

TEST_CASE("Comments padded to columns are parted where a known word begins") {
  Naming naming;
  naming.normalise.columns = 8;
  SymbolRule rule;
  rule.patterns = {{Source::comment, "{process}_{device}_{task:known}"}};
  naming.rules.push_back(rule);
  const auto reader = reader_of(naming);
  CHECK(parts(reader->read({"X0", "S1 LIFTUP", {}, Direction::event})) == "no rule");  // UP is not at a boundary
  CHECK(parts(reader->read({"X1", "S10 LIFTUP", {}, Direction::event})) == "|S10|LIFT|event|UP");
  CHECK(parts(reader->read({"X2", "S10 TABLDOWN", {}, Direction::event})) == "|S10|TABL|event|DOWN");
}

TEST_CASE("A rule may ask for words, which scripts without blanks also hold within words") {
  Naming naming = naming_of("*");
  naming.rules[0].has = {"LAMP", "push button", "램프"};
  naming.rules[0].role = Role::operator_panel;
  const auto reader = reader_of(naming);
  const auto role = [&](std::string_view name) { return reader->read({name, {}, {}, Direction::event}).role; };
  CHECK(role("S10_LAMP3") == Role::operator_panel);
  CHECK(role("S10 push_button 2") == Role::operator_panel);
  CHECK(role("비상램프") == Role::operator_panel);
  CHECK(role("S10_CLAMP") == Role::io);
  CHECK(role("클램프") == Role::io);  // a motion, although its letters hold the word for a lamp
}

TEST_CASE("A rule about the rest gives a role to what the other rules read, for later") {
  Naming naming = naming_of("{device}_{task...}");
  naming.rest.push_back(rule_of("*_(READY|OK)"));
  naming.rest[0].role = Role::constant;
  naming.rest[0].value = false;
  const auto reader = reader_of(naming);
  const Reading reading = reader->read({"AIR_OK", {}, {}, Direction::event});
  CHECK(reading.is_read());
  CHECK(reading.rest == Role::constant);
  CHECK_FALSE(reading.rest_value);
  CHECK(reader->read({"AIR_ON", {}, {}, Direction::event}).rest == Role::io);
}

TEST_CASE("Ignored symbols and fixed levels") {
  Naming naming = naming_of("{device...}_{task}");
  naming.ignore = {"SPARE*", "* SP"};
  naming.fixed = {{Level::line, "BB"}};
  const auto reader = reader_of(naming);
  CHECK(read(*reader, "SPARE_12") == "ignored");
  CHECK(read(*reader, "S10 DESK SP") == "ignored");
  CHECK(read(*reader, "DESK_START") == "BB||DESK|-|START");
  CHECK(reader->read({"DESK_START", {}, {}, {}}).levels->path == "BB_DESK");
}

TEST_CASE("Faults of patterns and expressions have their JSON pointer and column") {
  Naming naming = naming_of("{process}_{devise}");
  naming.rules.push_back(rule_of("{device"));
  naming.rules.push_back(rule_of("{device}"));
  naming.rules[2].fields = {{"device", "RB[0-9", {}}, {"process", "S.*", {}}};
  naming.normalise.replace = {{"(", ""}, {"a", "$3"}};
  std::vector<NamingFault> faults;
  CHECK(CompiledNaming::compile(std::move(naming), faults) == nullptr);
  REQUIRE(faults.size() == 6);
  CHECK(faults[0].pointer == "/normalise/replace/0");
  CHECK(faults[1].pointer == "/normalise/replace/1");
  CHECK(faults[2].pointer == "/rules/0/pattern");
  CHECK(faults[2].column == 11);
  CHECK(faults[3].message == "`{` without `}`; close the field, or write `\\{` for the character");
  CHECK(faults[4].pointer == "/rules/2/fields/device");
  CHECK(faults[5].pointer == "/rules/2/fields/process");
}

TEST_CASE("An archetype's text gives the text of its braces, which may be empty") {
  Naming naming;
  naming.archetypes.resize(1);
  naming.archetypes[0].texts = {{ArchetypeRole::operation, "{x} ECHO"},
                                {ArchetypeRole::event, "*AIR OK*|DOOR {x} CLOSED"},
                                {ArchetypeRole::start, "INTERLOCK{x}"}};
  std::vector<NamingFault> faults;
  const auto compiled = CompiledNaming::compile(std::move(naming), faults);
  REQUIRE(compiled != nullptr);
  std::string x;
  const ArchetypeText echo(*compiled, 0, 0);
  CHECK((echo.matches("PART OK ECHO", x) && x == "part_ok"));
  CHECK((echo.matches("ECHO", x) && x.empty()));
  CHECK_FALSE(echo.matches("ECHO PART", x));
  const ArchetypeText healthy(*compiled, 0, 1);
  CHECK(healthy.matches("MAIN AIR OK 1", x));
  CHECK((healthy.matches("door 2 closed", x) && x == "2"));
  const ArchetypeText interlock(*compiled, 0, 2);
  CHECK((interlock.matches("INTERLOCK3", x) && x == "3"));
  CHECK((interlock.matches("INTERLOCK 3", x) && x == "3"));
}

TEST_CASE("An exact rule reads names as the same pattern with expressions does") {
  Naming naming = naming_of("{line}_{process}_{device}_{direction}_{task}");
  naming.separators = "_";
  naming.rules[0].patterns[0].source = Source::name;
  naming.rules[0].fields = {{"direction", "", {{"I", Direction::event}, {"O", Direction::operation}}}};
  naming.tasks.vocabulary = false;
  Naming exact = naming;
  exact.rules[0].exact = true;
  for (const char* field : {"line", "process", "device", "task"}) {
    naming.rules[0].fields.push_back({field, "[\\pL\\pN]+", {}});
  }
  const auto general = reader_of(naming);
  const auto reader = reader_of(exact);
  std::mt19937 random(7);
  const std::vector<std::string> pieces = {"A", "b1", "I", "o", "O", "WELD", "Ü", "로봇", "_", "_", "_", "-", "9"};
  std::deque<std::string> names;  // readers keep views of them
  int followed = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string& name = names.emplace_back(std::to_string(i));
    for (int k = 0; k < 9; ++k) name += k % 2 == 0 && random() % 4 != 0 ? "_" : pieces[random() % pieces.size()];
    const Reading one = reader->read({name, {}, {}, {}});
    const Reading other = general->read({name, {}, {}, {}});
    INFO(name);
    if (!one.is_read()) {  // runs of separators, and those at the ends, are faults of an exact rule only
      const bool has_run = name.find("__") != name.npos || name.front() == '_' || name.back() == '_';
      CHECK((!other.is_read() || has_run));
      continue;
    }
    ++followed;
    REQUIRE(other.is_read());
    CHECK(one.levels->path == other.levels->path);
    CHECK(one.levels->process == other.levels->process);
    CHECK(one.task->text == other.task->text);
    CHECK(one.direction == other.direction);
  }
  CHECK(followed > 50);
}

TEST_CASE("Devices are numbered by their levels, without regard to the case of letters") {
  Naming naming = naming_of("{line}_{process}_{device}_{direction}_{task}");
  naming.rules[0].patterns[0].source = Source::name;
  naming.rules[0].exact = true;
  naming.rules[0].fields = {{"direction", "", {{"I", Direction::event}, {"O", Direction::operation}}}};
  const auto reader = reader_of(naming);
  const std::vector<std::string> names = {"L_P_agv_I_A", "L_P_AGV_O_A", "L_P_Захват_I_A", "L_P_захват_O_A",
                                          "L_Q_AGV_I_A"};
  std::vector<std::uint32_t> ids;
  for (const std::string& name : names) ids.push_back(reader->read({name, {}, {}, {}}).levels->device_id);
  CHECK(ids == std::vector<std::uint32_t>{0, 0, 1, 1, 2});
  CHECK(reader->devices() == 3);
  naming.units = Units::device;
  const auto of_devices = reader_of(naming);  // only the case of ASCII letters makes no difference
  ids.clear();
  for (const std::string& name : names) ids.push_back(of_devices->read({name, {}, {}, {}}).levels->device_id);
  CHECK(ids == std::vector<std::uint32_t>{0, 0, 1, 2, 3});
}

TEST_CASE("The pattern of an exact rule is fields that one separator joins") {
  const auto fault = [](std::string pattern, std::vector<FieldRule> fields = {}) {
    Naming naming = naming_of(std::move(pattern));
    naming.rules[0].patterns[0].source = Source::name;
    naming.rules[0].exact = true;
    naming.rules[0].fields = std::move(fields);
    std::vector<NamingFault> faults;
    CompiledNaming::compile(std::move(naming), faults);
    return faults.empty() ? std::string() : faults.front().pointer;
  };
  CHECK(fault("{device}-{task}").empty());
  CHECK(fault("{device}_{task...}") == "/rules/0/pattern");
  CHECK(fault("{device}_{task}_") == "/rules/0/pattern");
  CHECK(fault("{device}_{task}-{line}") == "/rules/0/pattern");
  CHECK(fault("{device}X{task}") == "/rules/0/pattern");
  CHECK(fault("{line}_{task}") == "/rules/0/pattern");
  CHECK(fault("{device}_{device}_{task}") == "/rules/0/pattern");
  CHECK(fault("{device}_{direction}_{task}") == "/rules/0/fields");
  CHECK(fault("{device}_{task}", {{"device", "[A-Z]+", {}}}) == "/rules/0/fields/device");
}

}  // namespace
}  // namespace symplant::name
