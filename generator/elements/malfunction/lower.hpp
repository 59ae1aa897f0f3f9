// Lowers the malfunctions.
#pragma once

#include "lower/add_condition.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Fills EngineTables::malfunctions, and adds their random times.
void lower_malfunctions(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables);

}  // namespace symplant::lower
