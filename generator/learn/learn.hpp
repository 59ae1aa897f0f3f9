// Learns the times of a plant from recordings.
#pragma once

#include <vector>

#include "learn/input.hpp"
#include "learn/learned.hpp"

namespace symplant::learn {

/// The times, and what is not seen. The plant must outlive the result. O(changes + samples log samples).
Learned learn_times(const model::PlantModel& plant, const std::vector<Input>& inputs);

}  // namespace symplant::learn
