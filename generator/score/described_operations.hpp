// Operations that the description uses to move parts, to switch inputs and to start or end malfunctions.
#pragma once

#include <vector>

#include "model/plant_model.hpp"

namespace symplant::score {

/// For each symbol: whether it is an operation, and a condition of `material`, `follow` or `malfunctions`, or a
/// formula, reads it or a state that it commands. O(symbols + conditions).
std::vector<bool> described_operations(const model::PlantModel& plant);

}  // namespace symplant::score
