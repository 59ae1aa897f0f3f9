// Checks the C++ classes that a description names: `type` and `behaviour` of devices.
#pragma once

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Reports invalid class names, and a behavior of devices with different structure. Its devices must have the same
/// operations, events, states, inputs and numeric symbols; their transitions may differ. Conditions and values of units
/// must be complete. O(described devices and their symbols).
void check_classes(const PlantModel& plant, description::Faults& faults);

}  // namespace symplant::model
