// Finds what recordings do not show.
#pragma once

#include <vector>

#include "learn/durations.hpp"
#include "learn/input.hpp"
#include "learn/learned.hpp"

namespace symplant::learn {

/// O(plant + series).
NotSeen not_seen(const model::PlantModel& plant, const std::vector<Input>& inputs, const Moves& moves);

}  // namespace symplant::learn
