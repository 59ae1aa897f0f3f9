// Finds symbols that share an address.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::model {

/// Sets Symbol::leader of symbols that share an address of one controller. The event that a unit drives leads, else the
/// first symbol. Returns pairs of events on one address that different units drive: second, first. The second one loses
/// its address, so that the plant can run. O(symbols).
std::vector<std::array<std::uint32_t, 2>> find_shared_addresses(PlantModel& plant);

}  // namespace symplant::model
