// Reads `signals` of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "description/json_entry.hpp"
#include "elements/signal/given.hpp"

namespace symplant::description {

/// The object `signals`. Faults of shape are reported; formulas and names are not resolved.
std::vector<GivenSignal> signal_entries(const nlohmann::json& object, ShapeFaults& faults);

}  // namespace symplant::description
