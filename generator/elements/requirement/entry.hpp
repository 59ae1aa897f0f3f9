// Reads `requirements` of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "description/json_entry.hpp"
#include "elements/requirement/given.hpp"

namespace symplant::description {

/// The array `requirements`.
std::vector<GivenRequirement> requirement_entries(const nlohmann::json& array, ShapeFaults& faults);

}  // namespace symplant::description
