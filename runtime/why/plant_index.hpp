// Look-ups over a plant's tables that explanations need.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "symplant/tables/tables.hpp"
#include "symplant/why/conditions.hpp"
#include "symplant/why/symbol_use.hpp"

namespace symplant::why {

/// O(plant). Refers to the tables.
struct PlantIndex {
  explicit PlantIndex(const tables::PlantTables& tables);

  /// The rows that disable a unit. O(log disables).
  std::span<const tables::DisableRow> disables_of(std::uint32_t unit) const;
  /// A unit's condition by its number in a transition. O(log units with conditions).
  Network condition_of(std::uint32_t unit, std::uint16_t number) const;
  /// The symbol of a unit's operation; kNone if it has none.
  std::uint32_t operation_of(std::uint32_t unit, std::uint8_t operation) const;
  /// The row in PlantTables::behaviour_units of a unit, or null.
  const tables::BehaviourUnit* behaviour_of(std::uint32_t unit) const;

  const tables::PlantTables& tables;
  SymbolUse use;
  Conditions conditions;
  std::vector<tables::DisableRow> disables;        ///< sorted by unit
  std::vector<std::uint32_t> symbol_of_operation;  ///< by bit
  std::vector<std::string_view> behaviour_names;
};

}  // namespace symplant::why
