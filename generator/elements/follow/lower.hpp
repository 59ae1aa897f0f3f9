// Lowers the symbols that follow a condition.
#pragma once

#include "lower/add_condition.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Fills EngineTables::follows.
void lower_follows(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables);

}  // namespace symplant::lower
