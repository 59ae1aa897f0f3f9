// What `symplant map` says below the rows: sizes, status block, watchdog, policies.
#pragma once

#include <string>

#include "symplant/core/tables.hpp"
#include "symplant/link/io_map.hpp"

namespace symplant::app {

/// "coil 1", "holding registers 10-11".
std::string place_text(const link::IoPoint& point);
/// "00002", "40011-40012".
std::string modicon_text(const link::IoPoint& point);
/// "low word first".
std::string word_order_text(core::WordOrder order);

/// Lines about a map.
std::string map_notes(const core::PlantTables& tables, const link::IoMap& map, const core::LinkSettings& settings);

}  // namespace symplant::app
