// Finds why moves cannot be learned from.
#pragma once

#include <vector>

#include "learn/durations.hpp"
#include "learn/input.hpp"
#include "learn/learned.hpp"

namespace symplant::learn {

/// The devices of which moves are not used, by unit, with the reason if these are many. Follows the recordings once
/// more if there are such devices: O(plant + changes of all inputs).
std::vector<UnusedMoves> unused_moves(const model::PlantModel& plant, const std::vector<Input>& inputs,
                                      const Moves& moves);

}  // namespace symplant::learn
