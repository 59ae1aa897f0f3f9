// The rows of `symplant map`: where each symbol of a controller is, and what drives it.
#pragma once

#include <cstdint>

#include "base/text_source.hpp"
#include "model/plant_model.hpp"
#include "symplant/link/io_map.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::app {

/// Writes a head and one row for each symbol that a link to the controller carries, in columns of equal width. Makes
/// each row twice, once to measure it, so that only one is in memory. O(symbols).
void write_map_table(const model::PlantModel& plant, const tables::PlantTables& tables, std::uint32_t controller,
                     const link::IoMap& map, base::TextSink& sink);

}  // namespace symplant::app
