// Lowers values and signals.
#pragma once

#include "lower/add_condition.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Fills EngineTables::values, except for the comparisons, which conditions add. O(formulas).
void lower_values(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables);

}  // namespace symplant::lower
