// Joins devices that agree in their times.
#pragma once

#include <string>
#include <vector>

#include "learn/learned.hpp"

namespace symplant::learn {

/// Devices of one kind agree if they have the same times, to half a resolution, and none has two groups of durations.
/// Those that a pattern names are one group, whose times are made of all its samples. O(times log times).
std::vector<LearnedGroup> groups_of(const model::PlantModel& plant, std::vector<LearnedDevice> devices);

/// The last level of a device's path, with `#` for each number: `CLAMP#`. O(path).
std::string kind_of(const model::Unit& unit);

/// The key of a transition in `times` of plant.json.
std::string key_of(const model::PlantModel& plant, const model::Unit& unit, const LearnedTransition& transition);

}  // namespace symplant::learn
