// Checks the names of kinds, tracks and places.
#pragma once

#include <vector>

#include "elements/material/entries.hpp"
#include "text/ascii.hpp"

namespace symplant::model {

/// The kinds of parts, with their faults reported.
std::vector<PartKind> checked_kinds(const std::vector<description::GivenKind>& given, description::Faults& faults);

/// Reports faulty names of tracks and places, which have one namespace with devices. Returns those that are the names
/// of devices.
text::ByName<bool> names_of_devices(const PlantModel& plant, const MadeMaterial& made, description::Faults& faults);

/// Reports states that a description adds although a sensor has that task. O(symbols + units).
void check_tasks_of_sensors(const PlantModel& plant, description::Faults& faults);

}  // namespace symplant::model
