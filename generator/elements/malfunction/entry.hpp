// Reads `malfunctions` of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "description/json_entry.hpp"

namespace symplant::description {

/// The array `malfunctions`.
std::vector<GivenMalfunction> malfunction_entries(const nlohmann::json& array, ShapeFaults& faults);

}  // namespace symplant::description
