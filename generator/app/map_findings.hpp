// What is wrong with the maps of a plant's links.
#pragma once

#include "diag/diagnostic.hpp"
#include "model/plant_model.hpp"

namespace symplant::app {

/// Whether places of this plant can meet at all: some number is of more than 16 bits, or the description moves
/// something. O(symbols).
bool symbols_can_overlap(const model::PlantModel& plant);

/// Tells of symbols that stand on one place (SP316), and of settings that do not fit the map, where they stand in the
/// description. The plant must be without errors. O(symbols).
void add_map_findings(const model::PlantModel& plant, diag::Diagnostics& diagnostics);

}  // namespace symplant::app
