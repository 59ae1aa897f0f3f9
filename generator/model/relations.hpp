// Resolves the relations between units: conditions, disables, requirements.
#pragma once

#include "description/faults.hpp"
#include "model/matched_names.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Fills in Unit::conditions, first_input, disables and values, the requirements and the conditions of
/// PlantModel::follows. All units must be derived. O(symbols and description).
void add_relations(PlantModel& plant, MadeNames& made, description::Faults& faults);

}  // namespace symplant::model
