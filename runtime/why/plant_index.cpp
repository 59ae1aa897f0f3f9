// Look-ups over a plant's tables that explanations need.
#include "symplant/why/plant_index.hpp"

#include <algorithm>

#include "symplant/tables/names.hpp"

namespace symplant::why {

PlantIndex::PlantIndex(const tables::PlantTables& rows)
    : tables(rows),
      use(rows),
      conditions(rows),
      disables(rows.disables.begin(), rows.disables.end()),
      symbol_of_operation(rows.operation_bits, tables::kNone),
      behaviour_names(tables::split_names(rows.behaviour_names)) {
  std::stable_sort(disables.begin(), disables.end(),
                   [](const tables::DisableRow& a, const tables::DisableRow& b) { return a.unit < b.unit; });
  for (std::uint32_t s = 0; s < rows.symbols.size(); ++s) {
    const tables::SymbolRow& symbol = rows.symbols[s];
    const bool bit = symbol.type() == tables::DataType::boolean;
    if (bit && symbol.direction() == tables::Direction::operation) symbol_of_operation[symbol.index] = s;
  }
}

std::span<const tables::DisableRow> PlantIndex::disables_of(std::uint32_t unit) const {
  const auto begin = std::partition_point(disables.begin(), disables.end(),
                                          [unit](const tables::DisableRow& row) { return row.unit < unit; });
  const auto end =
      std::partition_point(begin, disables.end(), [unit](const tables::DisableRow& row) { return row.unit == unit; });
  return {begin, end};
}

Network PlantIndex::condition_of(std::uint32_t unit, std::uint16_t number) const {
  const auto row = std::lower_bound(
      tables.conditioned_units.begin(), tables.conditioned_units.end(), unit,
      [](const tables::ConditionedUnit& conditioned, std::uint32_t wanted) { return conditioned.unit < wanted; });
  return conditions.network(row->first_condition + number);
}

std::uint32_t PlantIndex::operation_of(std::uint32_t unit, std::uint8_t operation) const {
  return symbol_of_operation[tables.units[unit].operation_bit + operation];
}

const tables::BehaviourUnit* PlantIndex::behaviour_of(std::uint32_t unit) const {
  const auto row = std::lower_bound(
      tables.behaviour_units.begin(), tables.behaviour_units.end(), unit,
      [](const tables::BehaviourUnit& behaviour, std::uint32_t wanted) { return behaviour.unit < wanted; });
  return row != tables.behaviour_units.end() && row->unit == unit ? &*row : nullptr;
}

}  // namespace symplant::why
