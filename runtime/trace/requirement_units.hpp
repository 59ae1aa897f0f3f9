// The units in the conditions of a requirement.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::trace {

/// The symbols that the conditions of a requirement read directly. O(symbols + watches).
std::set<std::uint32_t> requirement_symbols(const tables::PlantTables& tables, std::uint32_t requirement);

/// The units that its conditions name, and the units of the symbols that they name; each once, ascending. O(watches).
std::vector<std::uint32_t> requirement_units(const tables::PlantTables& tables, std::uint32_t requirement);

/// The locations of parts that its conditions name. O(watches).
std::set<std::uint32_t> requirement_locations(const tables::PlantTables& tables, std::uint32_t requirement);

}  // namespace symplant::trace
