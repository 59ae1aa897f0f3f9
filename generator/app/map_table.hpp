// The rows of `symplant map`: where each symbol of a controller is, and what drives it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/text_source.hpp"
#include "model/plant_model.hpp"
#include "symplant/link/io_map.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::app {

/// The map of a link: its points, and for a link that goes to the PLC their addresses there.
struct ShownMap {
  const link::IoMap& map;
  const std::vector<std::string>* addresses = nullptr;  ///< of the points in their order; null: Modbus numbers
};

/// Writes a head and one row for each symbol that a link to the controller carries, in columns of equal width. Makes
/// each row twice, once to measure it, so that only one is in memory. O(symbols).
void write_map_table(const model::PlantModel& plant, const tables::PlantTables& tables, std::uint32_t controller,
                     const ShownMap& shown, base::TextSink& sink);

}  // namespace symplant::app
