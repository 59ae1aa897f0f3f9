// Reads `values` of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "description/json_entry.hpp"
#include "elements/value/given.hpp"

namespace symplant::description {

/// The object `values`. Faults of shape are reported; formulas and names are not resolved.
std::vector<GivenValue> value_entries(const nlohmann::json& object, ShapeFaults& faults);

}  // namespace symplant::description
