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

}  // namespace

std::vector<std::uint32_t> requirement_units(const tables::PlantTables& tables, std::uint32_t requirement) {
  const auto reads = [&](std::uint32_t condition) { return reader_of(tables, condition) == requirement; };
  std::set<std::uint32_t> units;
  for (const tables::UnitWatch& watch : tables.unit_watches) {
    if (reads(watch.condition)) units.insert(watch.unit);
  }
  std::set<std::uint32_t> operations;
  std::set<std::uint32_t> events;
  for (const tables::BitWatch& watch : tables.operation_watches) {
    if (reads(watch.condition)) operations.insert(watch.bit);
  }
  for (const tables::BitWatch& watch : tables.event_watches) {
    if (reads(watch.condition)) events.insert(watch.bit);
  }
  for (const tables::SymbolRow& symbol : tables.symbols) {
    if (symbol.type() != tables::DataType::boolean || symbol.unit == tables::kNone) continue;
    const auto& bits = symbol.direction() == tables::Direction::operation ? operations : events;
    if (bits.contains(symbol.index)) units.insert(symbol.unit);
  }
  return {units.begin(), units.end()};
}

}  // namespace symplant::trace
