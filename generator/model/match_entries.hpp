// Matches entries of the description with devices, and joins them.
#pragma once

#include <string>
#include <vector>

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Sets Unit::described from all entries that match the device by exact name or pattern, joined key by key: an exact
/// name beats every pattern, and of patterns the one with more literal characters wins. Returns how many devices each
/// pattern matches, in words. O(units * patterns).
std::vector<std::string> match_entries(PlantModel& plant, description::Faults& faults);

/// Reports names in a pattern's entry that its devices lack. Call once, after all units are derived.
void report_lacks(const PlantModel& plant, description::Faults& faults);

}  // namespace symplant::model
