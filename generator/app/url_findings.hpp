// What is wrong with the URLs of a plant's links.
#pragma once

#include "diag/diagnostic.hpp"
#include "model/plant_model.hpp"

namespace symplant::app {

/// Tells of links that cannot be opened on whatever machine, and of two that cannot be on one, where they stand in the
/// description. O(links log links).
void add_url_findings(const model::PlantModel& plant, diag::Diagnostics& diagnostics);

}  // namespace symplant::app
