// The malfunctions as JSON, for programs.
#pragma once

#include "model/plant_model.hpp"
#include "view/json_writer.hpp"

namespace symplant::view {

/// The member `malfunctions` of an open object; nothing for a plant without any. O(malfunctions and their devices).
void write_malfunctions(const model::PlantModel& plant, JsonWriter& json);

}  // namespace symplant::view
