// Symbols that share an address.
#pragma once

#include <cstdint>

#include "model/plant_model.hpp"

namespace symplant::property::files {

/// Whether the symbol is on an address with an event of a device that the user's code drives.
bool may_be_driven_by_code(const model::PlantModel& plant, std::uint32_t symbol);

/// Whether an event of the unit shares its address. A person can then switch it by two devices, in the order of a
/// scenario's step, which an object of JSON does not keep.
bool shares_an_address(const model::PlantModel& plant, std::uint32_t unit);

}  // namespace symplant::property::files
