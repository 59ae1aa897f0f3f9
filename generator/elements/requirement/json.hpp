// The requirements as JSON, for programs.
#pragma once

#include "model/plant_model.hpp"
#include "view/json_writer.hpp"

namespace symplant::view {

/// The member `requirements` of an open object. O(requirements).
void write_requirements(const model::PlantModel& plant, JsonWriter& json);

}  // namespace symplant::view
