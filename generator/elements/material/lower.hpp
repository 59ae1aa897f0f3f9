// Lowers the material flow.
#pragma once

#include "lower/add_condition.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Fills EngineTables::material except for its counters, and adds the random times of its sources.
void lower_material(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables);

}  // namespace symplant::lower
