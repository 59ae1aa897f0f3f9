// Findings about the maps of a plant's links.
#pragma once

#include "diag/diagnostic.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::map {

/// The link of this controller in plant.json, preferably one that goes to the PLC; null if there is none.
const description::LinkDescription* link_of(const model::PlantModel& plant, std::uint32_t controller);

/// The link of plant.json to this controller that goes to the PLC; null if there is none.
const description::LinkDescription* client_link_of(const model::PlantModel& plant, std::uint32_t controller);

/// Whether symbols of this plant can overlap at all, or lose the numbers of their addresses: a symbol has more than 16
/// bits, a link of the description has settings, or some addresses have no number on a link. O(symbols).
bool map_can_have_findings(const model::PlantModel& plant);

/// Reports symbols with overlapping addresses (SP316), addresses without a number (SP317), and settings that do not fit
/// the map, at their locations in the description. The plant must be without errors. O(symbols).
void add_map_findings(const model::PlantModel& plant, const lower::EngineTables& lowered,
                      diag::Diagnostics& diagnostics);

}  // namespace symplant::map
