// Which states of devices occurred while which operations were on.
#pragma once

#include <cstdint>
#include <istream>
#include <vector>

#include "symplant/trace/plant_names.hpp"

namespace symplant::suite {

/// Pairs of a device's state and an operation that were seen at one time in a run, as ascending numbers. A device that
/// moves is in neither state. `vcd` is the VCD file of the run. O(changes * (operations + devices)).
std::vector<std::uint64_t> state_pairs(std::istream& vcd, const trace::PlantNames& names);

}  // namespace symplant::suite
