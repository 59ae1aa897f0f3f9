// Resolves the alarms of the description.
#pragma once

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Fills PlantModel::alarms: those of each name or pattern in list order, each once. The plant is otherwise complete.
/// O(alarms * (symbols + values)).
void resolve_alarms(PlantModel& plant, description::Faults& faults);

/// PlantModel::alarms with each output of a value as one, whose `value` is the number of the output. O(alarms).
std::vector<Alarm> alarms_by_output(const PlantModel& plant);

}  // namespace symplant::model
