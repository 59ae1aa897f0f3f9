// The material flow as JSON, for programs.
#pragma once

#include "model/plant_model.hpp"
#include "view/json_writer.hpp"

namespace symplant::view {

/// The member `material` of an open object; nothing for a plant without material. O(material).
void write_material(const model::PlantModel& plant, JsonWriter& json);

}  // namespace symplant::view
