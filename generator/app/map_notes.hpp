// The lines below the rows of `symplant map`: sizes, status block, watchdog, policies.
#pragma once

#include <string>

#include "model/plant_model.hpp"
#include "symplant/link/client/parts.hpp"
#include "symplant/link/io_map.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::app {

/// "coil 1", "holding registers 10-11".
std::string address_text(const link::IoPoint& point);
/// "00002", "40011-40012".
std::string modicon_text(const link::IoPoint& point);
/// "low word first".
std::string word_order_text(link::WordOrder order);

/// The lines about the map of a link that goes to the PLC.
std::string client_map_notes(const model::PlantModel& plant, const link::client::ClientParts& parts);

/// The lines about a map.
std::string map_notes(const tables::PlantTables& tables, const link::IoMap& map, const link::LinkSettings& settings);

}  // namespace symplant::app
