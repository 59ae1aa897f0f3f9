// Resolves the signals of the description.
#pragma once

#include "description/faults.hpp"
#include "model/condition_reader.hpp"
#include "model/matched_names.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Fills in the rows and formulas of PlantModel::signals; an entry with a fault is left out. O(signals).
void resolve_signals(PlantModel& plant, ConditionReader& conditions, MadeNames& made, description::Faults& faults);

}  // namespace symplant::model
