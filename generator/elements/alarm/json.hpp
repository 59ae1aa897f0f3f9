// The alarms as JSON, for programs.
#pragma once

#include "model/plant_model.hpp"
#include "view/json_writer.hpp"

namespace symplant::view {

/// The member `alarms` of an open object: names of operations and values; none without alarms. O(alarms).
void write_alarms(const model::PlantModel& plant, JsonWriter& json);

}  // namespace symplant::view
