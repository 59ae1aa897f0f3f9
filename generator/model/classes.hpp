// The C++ classes that a description names: `type` and `behaviour` of devices.
#pragma once

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Faults where a name is none that a class can have, and where one behaviour is for devices that it cannot all serve:
/// they must have the same operations, events, states, inputs and numbers (their transitions may differ). Conditions
/// and values of units are known. O(described devices and what they have).
void check_classes(const PlantModel& plant, description::Faults& faults);

}  // namespace symplant::model
