// Reads `times` of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "description/json_entry.hpp"
#include "elements/times/given.hpp"

namespace symplant::description {

/// The object `times`.
std::vector<GivenTimes> times_entries(const nlohmann::json& object, ShapeFaults& faults);

}  // namespace symplant::description
