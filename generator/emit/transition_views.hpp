// The views of a type's d_ext, d_int, times and guards.
#pragma once

#include <string>
#include <vector>

#include "emit/render.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// The enumerators of a type's class, by number.
struct Enumerators {
  std::vector<std::string> operations;
  std::vector<std::string> events;
  std::vector<std::string> states;
};

/// Adds to the view of a type its lists `times`, `guards`, `transitions`, and those of the class's functions:
/// `operation_rules`, `commanded_states`, `automatic_states`, `spring_states`. `devices` are its units.
/// O(transitions * log transitions).
void add_transitions(View& view, const lower::Type& type, const Enumerators& names,
                     const std::vector<std::uint32_t>& devices, const lower::EngineTables& tables,
                     const model::PlantModel& plant);

}  // namespace symplant::emit
