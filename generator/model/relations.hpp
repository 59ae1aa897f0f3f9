// Resolves the relations between units: conditions, disables, requirements.
#pragma once

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Fills in Unit::conditions, first_input, disables and values, and the requirements. All units must be derived.
/// O(symbols and description).
void add_relations(PlantModel& plant, description::Faults& faults);

}  // namespace symplant::model
