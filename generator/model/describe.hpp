// Which entries of the description speak of which device, and what they come to together.
#pragma once

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Gives every unit what the description says of its device, by its exact name and by patterns, joined key by key: an
/// exact name beats every pattern, of patterns the one with more literal characters does. O(units * patterns).
void describe_units(PlantModel& plant, description::Faults& faults);

/// Reports what the devices that match a pattern lack of what its entry names; called once all of them are described.
void report_lacks(const PlantModel& plant, description::Faults& faults);

}  // namespace symplant::model
