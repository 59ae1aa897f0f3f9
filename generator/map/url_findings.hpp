// Findings about the URLs of a plant's links.
#pragma once

#include "diag/diagnostic.hpp"
#include "model/plant_model.hpp"

namespace symplant::map {

/// Reports links that no machine can open, and links that share a port, at their locations in the description.
/// O(links log links).
void add_url_findings(const model::PlantModel& plant, diag::Diagnostics& diagnostics);

}  // namespace symplant::map
