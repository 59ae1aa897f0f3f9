// Lowers the requirements.
#pragma once

#include "lower/add_condition.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Fills EngineTables::requirements and their names.
void lower_requirements(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables);

}  // namespace symplant::lower
