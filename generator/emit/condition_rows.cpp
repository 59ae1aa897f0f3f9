// Rows of conditions, watches and behaviors.
#include "emit/condition_rows.hpp"

#include <unordered_map>

#include "elements/material/rows.hpp"
#include "emit/model_text.hpp"
#include "emit/row_text.hpp"

namespace symplant::emit {
namespace {

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
    row_text(rows, tables.conditions[i]).number(i).text(": ").comment(readers[i]).text("\n");
  }
  return rows.take();
}

std::string conditioned_unit_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::ConditionedUnit& row : tables.conditioned_units) {
    row_text(rows, row).comment(plant.units[row.unit].path).text("\n");
  }
  return rows.take();
}

std::string unit_watch_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::UnitWatch& row : tables.unit_watches) {
    const model::Unit& unit = plant.units[row.unit];
    const bool moving = row.state == tables::kMovingState;
    row_text(rows, row)
        .comment(unit.path)
        .text(".")
        .comment(moving ? "moving" : unit.states[row.state].name)
        .text("\n");
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
    row_text(rows, row).comment(plant.symbols[symbols.at(row.bit)].name()).text("\n");
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
    row_text(rows, row).comment(short_condition_text(atom, plant)).text("\n");
  }
  return rows.take();
}

std::string part_watch_rows(const lower::EngineTables& tables) {
  RowWriter rows;
  for (const tables::ValueWatch& row : tables.part_watches) {
    bare_row(rows, row).text("\n");
  }
  return rows.take();
}

std::string overrun_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::OverrunRow& row : tables.overruns) {
    row_text(rows, row).comment(plant.units[row.unit].path).text("\n");
  }
  return rows.take();
}

std::string behaviour_unit_rows(const lower::EngineTables& tables, const model::PlantModel& plant) {
  RowWriter rows;
  for (const tables::BehaviourUnit& row : tables.behaviour_units) {
    const model::Unit& unit = plant.units[row.unit];
    row_text(rows, row).comment(unit.path).text(", ").comment(unit.described->behaviour).text("\n");
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
