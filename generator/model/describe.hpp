// Which entries of the description speak of which device, and what they come to together.
#pragma once

#include "model/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Gives every unit what the description says of its device, by its exact name and by patterns, joined key by key: an
/// exact name beats every pattern, of patterns the one with more literal characters does. O(units * patterns).
void describe_units(PlantModel& plant, Faults& faults);

}  // namespace symplant::model
