// The engine's tables with the memory that they point to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/core/tables.hpp"

namespace symplant::lower {

/// One device type: what units of equal structure share.
struct Type {
  std::uint32_t example;  ///< the first unit of this type
  std::uint8_t operations;
  std::uint8_t events;
  std::uint8_t states;
  std::uint8_t rest;
  core::Actuation actuation;
  std::vector<core::Transition> transitions;
  std::vector<core::EventMasks> enter;
  std::vector<core::EventMasks> leave;
  std::vector<std::uint8_t> operation_targets;
};

/// Movable; `tables()` points into it.
struct EngineTables {
  std::string name;
  std::vector<Type> types;
  std::vector<core::UnitRow> units;
  std::vector<core::TransitionTimes> times;
  std::vector<core::RandomTime> random_times;
  std::vector<core::SymbolRow> symbols;
  std::vector<core::SymbolListRow> lists;
  std::vector<core::InitialValue> initial_values;
  std::vector<core::SharedAddress> shared_addresses;
  std::vector<core::DisableRow> disables;
  std::vector<core::ConditionRow> conditions;
  std::vector<core::ConditionedUnit> conditioned_units;
  std::vector<core::UnitWatch> unit_watches;
  std::vector<core::BitWatch> operation_watches;
  std::vector<core::BitWatch> event_watches;
  std::vector<core::ValueWatch> operation_value_watches;
  std::vector<core::ValueWatch> event_value_watches;
  std::vector<core::RequirementRow> requirements;
  std::vector<core::BehaviourUnit> behaviour_units;
  std::vector<std::uint32_t> behaviour_values;
  std::uint32_t operation_bits = 0;
  std::uint32_t event_bits = 0;
  std::uint32_t operation_slots = 0;
  std::uint32_t event_slots = 0;
  std::string unit_names;  ///< blobs: each text ended by a NUL
  std::string state_names;
  std::string symbol_names;  ///< two texts a symbol: name, address
  std::string requirement_names;
  std::string behaviour_names;
  std::string list_names;
  std::string controller_names;

  std::vector<core::TypeRow> type_rows;  ///< of `types`, as the engine wants them; made by finish()

  void finish();
  core::PlantTables tables() const;
};

}  // namespace symplant::lower
