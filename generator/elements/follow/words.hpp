// Symbols that follow a condition in words, for tables and pictures.
#pragma once

#include <string>

#include "model/plant_model.hpp"

namespace symplant::view {

/// "COND", or of a switch with hysteresis "COND; off: COND". O(the conditions).
std::string follow_text(const model::Follow& follow, const model::PlantModel& plant);

}  // namespace symplant::view
