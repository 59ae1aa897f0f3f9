// Finds the list and the controller of a symbol.
#pragma once

#include <cstdint>

#include "symplant/tables/tables.hpp"

namespace symplant::tables {

/// The index in PlantTables::lists; 0 if there are no lists. O(log lists).
std::uint32_t list_of(const PlantTables& tables, std::uint32_t symbol) noexcept;

/// The index in PlantTables::controller_names; 0 if there are no lists. O(log lists).
std::uint32_t controller_of(const PlantTables& tables, std::uint32_t symbol) noexcept;

}  // namespace symplant::tables
