// Which units a requirement looks at.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::trace {

/// By what its conditions name: units, and the units of symbols; each once, in the plant's order. O(watches).
std::vector<std::uint32_t> requirement_units(const tables::PlantTables& tables, std::uint32_t requirement);

}  // namespace symplant::trace
