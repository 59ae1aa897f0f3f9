// Reads `values` of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "description/json_entry.hpp"
#include "elements/value/given.hpp"

namespace symplant::description {

/// The object `values`. Faults of shape are reported; formulas and names are not resolved.
std::vector<GivenValue> value_entries(const nlohmann::json& object, ShapeFaults& faults);

/// Sorts the values as the text of the plant.json has them: their order has a meaning.
void sort_as_written(std::vector<GivenValue>& values, std::string_view text);

}  // namespace symplant::description
