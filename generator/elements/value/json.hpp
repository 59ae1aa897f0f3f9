// Values and signals as JSON, for programs.
#pragma once

#include "model/plant_model.hpp"
#include "view/json_writer.hpp"

namespace symplant::view {

/// The members `values` and `signals` of an open object; none that would be empty. O(formulas).
void write_values(const model::PlantModel& plant, JsonWriter& json);

}  // namespace symplant::view
