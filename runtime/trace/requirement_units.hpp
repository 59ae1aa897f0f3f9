// The units in the conditions of a requirement.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::trace {

/// The units that the conditions of a requirement name, and the units of the symbols that they name; each once,
/// ascending. O(symbols + watches).
std::vector<std::uint32_t> requirement_units(const tables::PlantTables& tables, std::uint32_t requirement);

}  // namespace symplant::trace
