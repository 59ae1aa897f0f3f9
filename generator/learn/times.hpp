// Learns the times of a device from its moves.
#pragma once

#include <vector>

#include "learn/durations.hpp"
#include "learn/learned.hpp"

namespace symplant::learn {

/// Which times of a transition plant.json gives in `times`: as a rule those of an earlier result.
struct GivenBefore {
  bool after = false;
  bool takes = false;
};

/// How long the command of a `held` device stays on. O(samples log samples).
LearnedTime overrun_time_of(std::vector<Sample> samples, const std::vector<Source>& sources);

/// The times of a transition of `unit` (docs/decisions/0066-learned-times.md). What is at most 2 resolutions of `after`
/// or `takes` is counted with the other one. O(moves log moves).
LearnedTransition learn_transition(const model::Unit& unit, const TransitionMoves& moves,
                                   const std::vector<Source>& sources, const GivenBefore& given);

}  // namespace symplant::learn
