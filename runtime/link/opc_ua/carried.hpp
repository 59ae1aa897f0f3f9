// The symbols that a link of OPC UA carries, and their positions in its images.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/link/image/map.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::opc_ua {

struct Carried {
  image::Map map;  ///< without a status
  std::vector<Unreachable> left_out;
};

/// All symbols of the controller, also those without an address, except what the settings exclude. Symbols that share
/// an address share a position. O(symbols).
Carried carried_symbols(const tables::PlantTables& tables, std::uint32_t controller, const LinkSettings& settings);

}  // namespace symplant::link::opc_ua
