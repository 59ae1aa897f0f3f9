// Which list a symbol stands in, and whose addresses it has.
#pragma once

#include <cstdint>

#include "symplant/tables/tables.hpp"

namespace symplant::tables {

/// The place in PlantTables::lists; 0 where there are none. O(log lists).
std::uint32_t list_of(const PlantTables& tables, std::uint32_t symbol) noexcept;

/// The place in PlantTables::controller_names; 0 where there are no lists. O(log lists).
std::uint32_t controller_of(const PlantTables& tables, std::uint32_t symbol) noexcept;

}  // namespace symplant::tables
