// Resolves the alarms of the description.
#pragma once

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Fills PlantModel::alarms: those of each name or pattern in list order, each once. The plant is otherwise complete.
/// O(alarms * (symbols + values)).
void resolve_alarms(PlantModel& plant, description::Faults& faults);

}  // namespace symplant::model
