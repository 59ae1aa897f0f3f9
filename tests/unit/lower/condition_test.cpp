// Conditions, their watches and their readers, from the plant model to the engine's tables.
#include <tuple>

#include "lower/lower.hpp"
#include "symplant/condition/truth_table.hpp"
#include "symplant/tables/names.hpp"
#include "unit/lower/altered_model.hpp"

namespace symplant::test {
namespace {

using lower::EngineTables;
using tables::ReaderKind;

/// Three devices of two states each: A1 and B2, each with operation and event.
model::PlantModel three_devices() {
  std::vector<std::string> names;
  for (const char* path : {"L_P_D1", "L_P_D2", "L_P_D3"}) {
    for (const char* task : {"_O_A1", "_O_B2", "_I_A1", "_I_B2"}) names.push_back(std::string(path) + task);
  }
  names.emplace_back("START");
  return model_of(names);
}

using Conditions = std::vector<std::tuple<std::uint64_t, std::uint32_t, int, ReaderKind>>;
Conditions conditions(const EngineTables& tables) {
  Conditions rows;
  for (const tables::ConditionRow& row : tables.conditions) {
    rows.emplace_back(row.truth, row.reader, row.reader_input, row.reader_kind);
  }
  return rows;
}

/// Unit or bit, condition, state (-1: a bit), input.
using Watches = std::vector<std::tuple<std::uint32_t, std::uint32_t, int, int>>;
Watches watches(const std::vector<tables::UnitWatch>& rows) {
  Watches all;
  for (const tables::UnitWatch& row : rows) all.emplace_back(row.unit, row.condition, row.state, row.input);
  return all;
}
Watches watches(const std::vector<tables::BitWatch>& rows) {
  Watches all;
  for (const tables::BitWatch& row : rows) all.emplace_back(row.bit, row.condition, -1, row.input);
  return all;
}

/// All events of some symbols.
Tree all_of(const model::PlantModel& plant, const std::vector<std::string>& names) {
  Tree tree;
  tree.kind = Tree::Kind::all;
  for (const std::string& name : names) tree.children.push_back(bit(symbol_of(plant, name)));
  return tree;
}

TEST_CASE("The conditions of a unit are adjacent, in the model's order, then come those of requirements") {
  model::PlantModel plant = three_devices();
  plant.units[0].conditions = {settled(1, 1), !settled(2, 0)};
  plant.units[2].conditions = {moving(0)};
  plant.requirements = {
      {"never both", tables::RequirementRow::Kind::never, settled(0, 1) && settled(1, 1), {}, 0},
      {"answers", tables::RequirementRow::Kind::expect, settled(0, 1), settled(1, 1), 5 * tables::kSecond}};
  const EngineTables tables = lower::lower(plant);
  CHECK(conditions(tables) == Conditions{{0b10, 0, 0, ReaderKind::unit},
                                         {0b01, 0, 0, ReaderKind::unit},
                                         {0b10, 2, 0, ReaderKind::unit},
                                         {0b1000, 0, 0, ReaderKind::requirement},
                                         {0b10, 1, 0, ReaderKind::requirement},
                                         {0b10, 1, 1, ReaderKind::requirement}});
  REQUIRE(tables.conditioned_units.size() == 2);
  CHECK(tables.conditioned_units[0].unit == 0);
  CHECK(tables.conditioned_units[0].first_condition == 0);
  CHECK(tables.conditioned_units[1].unit == 2);
  CHECK(tables.conditioned_units[1].first_condition == 2);
  REQUIRE(tables.requirements.size() == 2);
  CHECK(tables.requirements[0].kind == tables::RequirementRow::Kind::never);
  CHECK(tables.requirements[0].condition == 3);
  CHECK(tables.requirements[0].expected == 0);
  CHECK(tables.requirements[1].kind == tables::RequirementRow::Kind::expect);
  CHECK(tables.requirements[1].condition == 4);
  CHECK(tables.requirements[1].expected == 5);
  CHECK(tables.requirements[1].within == 5 * tables::kSecond);
  CHECK(tables::split_names(tables.requirement_names) == std::vector<std::string_view>{"never both", "answers"});
}

TEST_CASE("Watches are sorted by what they watch") {
  model::PlantModel plant = three_devices();
  plant.units[0].conditions = {moving(2), settled(2, 1) && settled(1, 0)};
  plant.units[1].conditions = {settled(2, 0)};
  const EngineTables tables = lower::lower(plant);
  CHECK(watches(tables.unit_watches) ==
        Watches{{1, 1, 0, 1}, {2, 0, tables::kMovingState, 0}, {2, 1, 1, 0}, {2, 2, 0, 0}});
}

TEST_CASE("A symbol is watched at its bit, on its own side") {
  model::PlantModel plant = three_devices();
  const std::uint32_t operation = symbol_of(plant, "L_P_D2_O_B2");
  const std::uint32_t event = symbol_of(plant, "L_P_D1_I_B2");
  const std::uint32_t start = symbol_of(plant, "START");
  plant.units[2].conditions = {bit(start) || bit(operation), bit(event)};
  const EngineTables tables = lower::lower(plant);
  CHECK(watches(tables.operation_watches) == Watches{{tables.symbols[operation].index, 0, -1, 1}});
  CHECK(watches(tables.event_watches) ==
        Watches{{tables.symbols[event].index, 1, -1, 0}, {tables.symbols[start].index, 0, -1, 0}});
  CHECK(tables.unit_watches.empty());
}

TEST_CASE("Symbols on one address are each watched at a separate bit") {
  Analysed analysed = analyse_rows({{"L_P_D_I_A1", "X1"}, {"L_P_D_I_B2", "X2"}, {"FIRST", "X5"}, {"SECOND", "X5"}});
  REQUIRE(analysed.derived);
  model::PlantModel plant = std::move(analysed.derived->plant);
  plant.units[0].conditions = {bit(symbol_of(plant, "SECOND")), bit(symbol_of(plant, "FIRST"))};
  const EngineTables tables = lower::lower(plant);
  CHECK(tables.event_watches.size() == 2);
  CHECK(tables.event_watches[0].bit != tables.event_watches[1].bit);
}

TEST_CASE("Numbers are compared in their slot") {
  Analysed analysed = analyse_rows({{"L_P_D_I_A1", "X1"},
                                    {"L_P_D_I_B2", "X2"},
                                    {"SPEED", "", "WORD", "0", "%QW1"},
                                    {"LEVEL", "", "INT", "0", "%IW1"},
                                    {"HEAT", "", "REAL", "0", "%ID4"}});
  REQUIRE(analysed.derived);
  model::PlantModel plant = std::move(analysed.derived->plant);
  const auto minus_two = static_cast<std::uint64_t>(-2);
  plant.units[0].conditions = {
      number(symbol_of(plant, "HEAT"), tables::Comparison::greater, tables::NumberKind::real, 0x3FF8'0000'0000'0000),
      number(symbol_of(plant, "LEVEL"), tables::Comparison::less_equal, tables::NumberKind::signed_integer,
             minus_two) &&
          number(symbol_of(plant, "SPEED"), tables::Comparison::equal, tables::NumberKind::unsigned_integer, 7)};
  const EngineTables tables = lower::lower(plant);
  REQUIRE(tables.operation_value_watches.size() == 1);
  const tables::ValueWatch& speed = tables.operation_value_watches[0];
  CHECK(speed.operand == 7);
  CHECK(speed.slot == 0);
  CHECK(speed.condition == 1);
  CHECK(speed.input == 1);
  CHECK(speed.comparison == tables::Comparison::equal);
  CHECK(speed.kind == tables::NumberKind::unsigned_integer);
  REQUIRE(tables.event_value_watches.size() == 2);
  CHECK(tables.event_value_watches[0].slot == 0);
  CHECK(tables.event_value_watches[0].condition == 1);
  CHECK(tables.event_value_watches[0].operand == minus_two);
  CHECK(tables.event_value_watches[1].slot == 1);
  CHECK(tables.event_value_watches[1].condition == 0);
  CHECK(tables.event_value_watches[1].kind == tables::NumberKind::real);
}

TEST_CASE("A constant condition watches nothing") {
  model::PlantModel plant = three_devices();
  plant.units[0].conditions = {constant(true), constant(false), settled(1, 0) || !settled(1, 0),
                               settled(1, 0) && !settled(1, 0)};
  const EngineTables tables = lower::lower(plant);
  CHECK(conditions(tables) == Conditions{{1, 0, 0, ReaderKind::unit},
                                         {0, 0, 0, ReaderKind::unit},
                                         {1, 0, 0, ReaderKind::unit},
                                         {0, 0, 0, ReaderKind::unit}});
  CHECK(tables.unit_watches.empty());
}

TEST_CASE("A condition of many inputs is a network whose inner tables come after all others") {
  model::PlantModel plant = three_devices();
  const std::vector<std::string> names{"L_P_D1_I_A1", "L_P_D1_I_B2", "L_P_D2_I_A1", "L_P_D2_I_B2", "L_P_D3_I_A1",
                                       "L_P_D3_I_B2", "L_P_D1_O_A1", "L_P_D2_O_A1", "START"};
  plant.units[1].conditions = {all_of(plant, names), settled(0, 0)};
  plant.requirements = {{"never all", tables::RequirementRow::Kind::never, all_of(plant, names), {}, 0}};
  const EngineTables tables = lower::lower(plant);
  REQUIRE(tables.conditions.size() > 3);
  CHECK(tables.conditions[0].reader_kind == ReaderKind::unit);
  CHECK(tables.conditions[1].reader_kind == ReaderKind::unit);
  CHECK(tables.conditions[2].reader_kind == ReaderKind::requirement);
  CHECK(tables.event_watches.size() == 2 * 7);
  CHECK(tables.operation_watches.size() == 2 * 2);

  // Every input of every table is fed by one watch or one inner table, and each inner table leads to a complete one.
  std::vector<std::vector<int>> feeds(tables.conditions.size(), std::vector<int>(condition::kMostInputs));
  for (const tables::BitWatch& row : tables.event_watches) ++feeds[row.condition][row.input];
  for (const tables::BitWatch& row : tables.operation_watches) ++feeds[row.condition][row.input];
  for (const tables::UnitWatch& row : tables.unit_watches) ++feeds[row.condition][row.input];
  for (std::size_t i = 3; i < tables.conditions.size(); ++i) {
    const tables::ConditionRow& row = tables.conditions[i];
    CHECK(row.reader_kind == ReaderKind::condition);
    CHECK(row.reader != i);
    ++feeds[row.reader][row.reader_input];
  }
  for (std::size_t i = 0; i < tables.conditions.size(); ++i) {
    std::size_t inputs = 0;
    while (inputs < feeds[i].size() && feeds[i][inputs] == 1) ++inputs;
    INFO("condition " << i);
    CHECK(inputs > 0);
    CHECK(std::count(feeds[i].begin(), feeds[i].end(), 0) == static_cast<int>(feeds[i].size() - inputs));
    if (i == 1) continue;
    CHECK(tables.conditions[i].truth == std::uint64_t{1} << ((std::size_t{1} << inputs) - 1));  // all of its inputs
  }
}

TEST_CASE("A watched unit, and one with conditions, takes the general path, one whose bits are watched does not") {
  model::PlantModel plant = three_devices();
  plant.units[0].conditions = {settled(1, 1), bit(symbol_of(plant, "L_P_D3_I_A1"))};
  const EngineTables tables = lower::lower(plant);
  CHECK(tables.units[0].general == 1);
  CHECK(tables.units[1].general == 1);
  CHECK(tables.units[2].general == 0);
}

}  // namespace
}  // namespace symplant::test
