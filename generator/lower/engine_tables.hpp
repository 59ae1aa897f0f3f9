// The engine's tables with their memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/condition/formula.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::lower {

/// A device type, shared by all units of equal structure.
struct Type {
  std::uint32_t example;  ///< the first unit of this type
  std::uint8_t operations;
  std::uint8_t events;
  std::uint8_t states;
  std::uint8_t rest;
  tables::Actuation actuation;
  std::vector<tables::Transition> transitions;
  std::vector<tables::EventMasks> enter;
  std::vector<tables::EventMasks> leave;
  std::vector<std::uint8_t> operation_targets;
  std::vector<tables::TransitionTimes> times;
  std::uint16_t travel = 0;
};

/// The material flow, as tables::MaterialTables.
struct Material {
  std::vector<tables::KindRow> kinds;
  std::vector<tables::TrackRow> tracks;
  std::vector<tables::DriveRow> drives;
  std::vector<tables::StopRow> stops;
  std::vector<tables::EndRow> ends;
  std::vector<tables::SensorRow> sensors;
  std::vector<tables::PlaceRow> places;
  std::vector<tables::TransferRow> transfers;
  std::vector<tables::WorkRow> work;
  std::vector<tables::SourceRow> sources;
  std::vector<std::uint32_t> sensor_kinds;
  std::vector<std::uint32_t> source_kinds;
  std::vector<tables::PartCounterRow> counters;
  std::string kind_names;
  std::string location_names;
  std::string transfer_names;
  std::string work_names;
  std::string source_names;

  tables::MaterialTables tables() const;
};

/// The malfunctions, as tables::MalfunctionTables.
struct Malfunctions {
  std::vector<tables::MalfunctionRow> rows;
  std::vector<tables::EffectRow> effects;
  std::vector<tables::MalfunctionUnit> units;
  std::vector<std::uint32_t> tracks;
  std::vector<tables::MalfunctionForce> forces;
  std::vector<tables::MalfunctionSet> sets;
  std::string names;

  tables::MalfunctionTables tables() const;
};

/// The values and signals, as tables::ValueTables.
struct Values {
  std::vector<tables::ValueRow> rows;
  std::vector<std::uint32_t> order;
  std::vector<tables::ChangeRow> changes;
  std::vector<tables::SignalRow> signals;
  std::vector<tables::FormulaRow> formulas;
  std::vector<tables::FormulaStep> steps;
  std::vector<tables::FormulaInput> inputs;
  std::vector<const condition::Formula*> sources;  ///< by formula: that of the plant model, which must outlive this
  std::vector<double> numbers;
  std::vector<tables::ComparisonRow> comparisons;
  std::uint32_t outputs = 0;
  std::string names;
  std::string formula_texts;

  tables::ValueTables tables() const;
};

/// Movable; `tables()` points into it.
struct EngineTables {
  EngineTables() = default;
  EngineTables(EngineTables&&) = default;
  EngineTables& operator=(EngineTables&&) = default;
  EngineTables copy() const;

  std::string name;
  std::vector<Type> types;
  std::vector<tables::UnitRow> units;
  std::vector<tables::TransitionTimes> times;
  std::vector<tables::RandomTime> random_times;
  std::vector<tables::SymbolRow> symbols;
  std::vector<tables::SymbolListRow> lists;
  std::vector<tables::InitialValue> initial_values;
  std::vector<tables::SharedAddress> shared_addresses;
  std::vector<tables::DisableRow> disables;
  std::vector<tables::ConditionRow> conditions;
  std::vector<tables::ConditionedUnit> conditioned_units;
  std::vector<tables::UnitWatch> unit_watches;
  std::vector<tables::BitWatch> operation_watches;
  std::vector<tables::BitWatch> event_watches;
  std::vector<tables::ValueWatch> operation_value_watches;
  std::vector<tables::ValueWatch> event_value_watches;
  std::vector<tables::RequirementRow> requirements;
  std::vector<tables::FollowRow> follows;
  std::vector<tables::OverrunRow> overruns;
  Material material;
  std::vector<tables::ValueWatch> part_watches;
  Malfunctions malfunctions;
  Values values;
  std::vector<tables::BehaviourUnit> behaviour_units;
  std::vector<std::uint32_t> behaviour_values;
  std::uint32_t operation_bits = 0;
  std::uint32_t event_bits = 0;
  std::uint32_t operation_slots = 0;
  std::uint32_t event_slots = 0;
  std::string unit_names;  ///< texts, each with a NUL after it; so are the other blobs
  std::string state_names;
  std::string symbol_names;  ///< two texts for each symbol: name, address
  std::string requirement_names;
  std::string behaviour_names;
  std::string list_names;
  std::string controller_names;

  std::vector<tables::TypeRow> type_rows;  ///< of `types`, for the engine; made by finish()

  void finish();
  tables::PlantTables tables() const;

 private:
  /// `type_rows` of a copy would point into the original.
  EngineTables(const EngineTables&) = default;
};

}  // namespace symplant::lower
