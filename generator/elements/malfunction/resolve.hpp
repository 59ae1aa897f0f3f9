// Resolves the malfunctions of the description.
#pragma once

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Fills PlantModel::malfunctions. The plant is otherwise complete. O(symbols + malfunctions * units).
void resolve_malfunctions(PlantModel& plant, description::Faults& faults);

}  // namespace symplant::model
