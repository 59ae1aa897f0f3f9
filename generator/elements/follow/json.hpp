// The symbols that follow a condition as JSON, for programs.
#pragma once

#include "model/plant_model.hpp"
#include "view/json_writer.hpp"

namespace symplant::view {

/// The member `follow` of an open object. O(follows).
void write_follows(const model::PlantModel& plant, JsonWriter& json);

}  // namespace symplant::view
