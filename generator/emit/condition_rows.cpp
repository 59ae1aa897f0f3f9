// Rows of conditions, watches, requirements and behaviors.
#include "emit/condition_rows.hpp"

#include <array>
#include <unordered_map>

#include "emit/material_rows.hpp"
#include "emit/model_text.hpp"
#include "emit/row_writer.hpp"

namespace symplant::emit {
namespace {

constexpr std::array<std::string_view, 11> kReaderKinds{
    "unit", "condition", "requirement", "follow", "drive", "stop", "end", "transfer", "work", "source", "malfunction"};
constexpr std::array<std::string_view, 5> kComparisons{"less", "less_equal", "equal", "greater_equal", "greater"};
constexpr std::array<std::string_view, 3> kNumberKinds{"signed_integer", "unsigned_integer", "real"};

template <std::size_t Size, class Enumeration>
std::string_view name_of(const std::array<std::string_view, Size>& names, Enumeration value) {
  return names[static_cast<std::size_t>(value)];
}

/// The symbols of one plane, by bit or slot.
std::unordered_map<std::uint32_t, std::uint32_t> symbols_of(const lower::EngineTables& tables,
                                                            tables::Direction direction, bool bits) {
  std::unordered_map<std::uint32_t, std::uint32_t> symbols;
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const tables::SymbolRow& row = tables.symbols[i];
    if (row.direction() == direction && (row.type() == tables::DataType::boolean) == bits) symbols[row.index] = i;
  }
  return symbols;
}

}  // namespace

std::string condition_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  const std::vector<std::string> readers = condition_readers(tables, plant);
  for (std::size_t i = 0; i < tables.conditions.size(); ++i) {
    const tables::ConditionRow& row = tables.conditions[i];
    rows.text("    {").hex(row.truth).text(", ").numbers(row.reader, unsigned{row.reader_input});
    rows.text(", tables::ReaderKind::").text(name_of(kReaderKinds, row.reader_kind)).text("},  // ").number(i);
    rows.text(": ").comment(readers[i]).text("\n");
  }
  return rows.take();
}

std::string conditioned_unit_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::ConditionedUnit& row : tables.conditioned_units) {
    rows.text("    {").numbers(row.unit, row.first_condition).text("},  // ").comment(plant.units[row.unit].path);
    rows.text("\n");
  }
  return rows.take();
}

std::string unit_watch_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::UnitWatch& row : tables.unit_watches) {
    const model::Unit& unit = plant.units[row.unit];
    const bool moving = row.state == tables::kMovingState;
    rows.text("    {").numbers(row.unit, row.condition).text(", ");
    moving ? rows.text("tables::kMovingState") : rows.number(unsigned{row.state});
    rows.text(", ").number(unsigned{row.input}).text("},  // ").comment(unit.path).text(".");
    rows.comment(moving ? "moving" : unit.states[row.state].name).text("\n");
  }
  return rows.take();
}

std::string bit_watch_rows(const lower::EngineTables& tables, const model::PlantModel& plant,
                           tables::Direction direction) {
  const auto& watches = direction == tables::Direction::operation ? tables.operation_watches : tables.event_watches;
  if (watches.empty()) return "";
  RowWriter rows;
  const auto symbols = symbols_of(tables, direction, true);
  for (const tables::BitWatch& row : watches) {
    rows.text("    {").numbers(row.bit, row.condition, unsigned{row.input}).text("},  // ");
    rows.comment(plant.symbols[symbols.at(row.bit)].name()).text("\n");
  }
  return rows.take();
}

std::string value_watch_rows(const lower::EngineTables& tables, const model::PlantModel& plant,
                             tables::Direction direction) {
  const auto& watches =
      direction == tables::Direction::operation ? tables.operation_value_watches : tables.event_value_watches;
  if (watches.empty()) return "";
  RowWriter rows;
  const auto symbols = symbols_of(tables, direction, false);
  for (const tables::ValueWatch& row : watches) {
    const std::uint32_t symbol = symbols.at(row.slot);
    condition::Tree atom;
    atom.kind = condition::Tree::Kind::atom;
    atom.atom = {condition::Atom::Kind::number, symbol, 0, model::kNone, row.comparison, row.kind, row.operand};
    rows.text("    {").hex(row.operand).text(", ").numbers(row.slot, row.condition, unsigned{row.input});
    rows.text(", tables::Comparison::").text(name_of(kComparisons, row.comparison)).text(", tables::NumberKind::");
    rows.text(name_of(kNumberKinds, row.kind)).text("},  // ").comment(short_condition_text(atom, plant)).text("\n");
  }
  return rows.take();
}

std::string requirement_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (std::size_t i = 0; i < tables.requirements.size(); ++i) {
    const tables::RequirementRow& row = tables.requirements[i];
    rows.text("    {tables::RequirementRow::Kind::");
    rows.text(row.kind == tables::RequirementRow::Kind::never ? "never, " : "expect, ");
    rows.numbers(row.condition, row.expected, row.within);
    if (row.earliest != 0) rows.text(", ").number(row.earliest);
    rows.text("},  // ").comment(plant.requirements[i].name).text("\n");
  }
  return rows.take();
}

std::string part_watch_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  for (const tables::ValueWatch& row : tables.part_watches) {
    rows.text("    {").hex(row.operand).text(", ").numbers(row.slot, row.condition, unsigned{row.input});
    rows.text(", tables::Comparison::").text(name_of(kComparisons, row.comparison)).text(", tables::NumberKind::");
    rows.text(name_of(kNumberKinds, row.kind)).text("},\n");
  }
  return rows.take();
}

std::string follow_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::FollowRow& row : tables.follows) {
    rows.text("    {").numbers(row.symbol, row.condition).text("},  // ").comment(plant.symbols[row.symbol].name());
    rows.text("\n");
  }
  return rows.take();
}

std::string overrun_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::OverrunRow& row : tables.overruns) {
    rows.text("    {").numbers(row.unit, row.after).text("},  // ").comment(plant.units[row.unit].path).text("\n");
  }
  return rows.take();
}

std::string behaviour_unit_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::BehaviourUnit& row : tables.behaviour_units) {
    const model::Unit& unit = plant.units[row.unit];
    rows.text("    {").numbers(row.unit, row.name, row.first_input, row.input_count, row.first_value, row.value_count);
    rows.text("},  // ").comment(unit.path).text(", ").comment(unit.described->behaviour).text("\n");
  }
  return rows.take();
}

std::string behaviour_value_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const std::uint32_t symbol : tables.behaviour_values) {
    rows.text("    ").number(symbol).text(",  // ").comment(plant.symbols[symbol].name()).text("\n");
  }
  return rows.take();
}

}  // namespace symplant::emit
