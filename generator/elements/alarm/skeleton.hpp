// Proposes the alarms of a list, by names.
#pragma once

#include <string>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::emit {

/// Operations whose names have a word of alarms, such as ALARM, FAULT, HORN or ERR, as names or as patterns of names
/// that differ in numbers and processes only, in list order. None that reset or test one. O(symbols).
std::vector<std::string> proposed_alarms(const model::PlantModel& plant);

}  // namespace symplant::emit
