// The units in the conditions of a requirement.
#include "symplant/trace/requirement_units.hpp"

#include <set>

namespace symplant::trace {
namespace {

/// The requirement that a condition belongs to; kNone if it belongs to no requirement.
std::uint32_t reader_of(const tables::PlantTables& tables, std::uint32_t condition) {
  for (;;) {
    const tables::ConditionRow& row = tables.conditions[condition];
    if (row.reader_kind == tables::ReaderKind::requirement) return row.reader;
    if (row.reader_kind != tables::ReaderKind::condition) return tables::kNone;
    condition = row.reader;
  }
}

/// The symbols that the conditions of a requirement read directly.
std::set<std::uint32_t> requirement_symbols(const tables::PlantTables& tables, std::uint32_t requirement) {
  const auto reads = [&](std::uint32_t condition) { return reader_of(tables, condition) == requirement; };
  std::set<std::uint32_t> operations;
  std::set<std::uint32_t> events;
  std::set<std::uint32_t> operation_slots;
  std::set<std::uint32_t> event_slots;
  const auto add = [&](const auto& watches, std::set<std::uint32_t>& found, auto index) {
    for (const auto& watch : watches) {
      if (reads(watch.condition)) found.insert(watch.*index);
    }
  };
  add(tables.operation_watches, operations, &tables::BitWatch::bit);
  add(tables.event_watches, events, &tables::BitWatch::bit);
  add(tables.operation_value_watches, operation_slots, &tables::ValueWatch::slot);
  add(tables.event_value_watches, event_slots, &tables::ValueWatch::slot);
  std::set<std::uint32_t> symbols;
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const tables::SymbolRow& symbol = tables.symbols[i];
    const bool operation = symbol.direction() == tables::Direction::operation;
    const bool bit = symbol.type() == tables::DataType::boolean;
    const auto& read = bit ? (operation ? operations : events) : (operation ? operation_slots : event_slots);
    if (read.contains(symbol.index)) symbols.insert(i);
  }
  return symbols;
}

}  // namespace

std::vector<std::uint32_t> requirement_units(const tables::PlantTables& tables, std::uint32_t requirement) {
  std::set<std::uint32_t> units;
  for (const tables::UnitWatch& watch : tables.unit_watches) {
    if (reader_of(tables, watch.condition) == requirement) units.insert(watch.unit);
  }
  for (const std::uint32_t symbol : requirement_symbols(tables, requirement)) {
    const tables::SymbolRow& row = tables.symbols[symbol];
    if (row.type() == tables::DataType::boolean && row.unit != tables::kNone) units.insert(row.unit);
  }
  return {units.begin(), units.end()};
}

}  // namespace symplant::trace
