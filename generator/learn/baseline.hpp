// How long moves took on average, by device: what `symplant watch` compares with to notice wear.
#pragma once

#include <vector>

#include "learn/durations.hpp"
#include "learn/learned.hpp"

namespace symplant::learn {

/// The statistics of one transition of one device, of moves that were not stopped: from leaving to arriving; where no
/// event shows when it left, from the cause to arriving; from the cause to leaving if that is over two resolutions or
/// if no event shows when it arrives. Outliers and times of fewer than two moves are left out. O(moves log moves).
std::vector<Baseline> baselines_of(const TransitionMoves& moves, const std::vector<Source>& sources);

}  // namespace symplant::learn
