// Operations that the description uses to move parts and to switch inputs.
#pragma once

#include <vector>

#include "model/plant_model.hpp"

namespace symplant::score {

/// For each symbol: whether a condition of `material` or `follow` reads it, or a state that it commands, and it is an
/// operation. O(symbols + conditions).
std::vector<bool> described_operations(const model::PlantModel& plant);

}  // namespace symplant::score
