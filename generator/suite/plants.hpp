// The plants of a suite: as described, faster, and slower.
#pragma once

#include "lower/engine_tables.hpp"
#include "suite/suite.hpp"

namespace symplant::suite {

/// The tables with the travel times of devices at a speed: a fifth (at least 1 ns), or three times as long. Times of
/// custom behaviors and of tracks do not change. O(tables).
lower::EngineTables at_speed(const lower::EngineTables& tables, Speed speed);

}  // namespace symplant::suite
