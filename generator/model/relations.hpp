// What ties units to each other: conditions, disables, requirements.
#pragma once

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Resolves what the description says across units, once all of them are derived: Unit::conditions, first_input,
/// disables and values, and the requirements. O(symbols and description).
void add_relations(PlantModel& plant, description::Faults& faults);

}  // namespace symplant::model
