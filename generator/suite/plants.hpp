// The plants of a suite: as described, faster, and slower.
#pragma once

#include "lower/engine_tables.hpp"
#include "suite/suite.hpp"

namespace symplant::suite {

/// The tables with each travel time of a device as the speed has it: a fifth (at least 1 ns), or three times. Times of
/// custom behaviors and of tracks stay. O(tables).
lower::EngineTables at_speed(const lower::EngineTables& tables, Speed speed);

}  // namespace symplant::suite
