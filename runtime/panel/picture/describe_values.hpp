// The description of values for the panel's clients.
#pragma once

#include <string>

#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

/// Appends the key `values` of `GET /api/v1/plant`: each output of each value. O(values * log(units)).
void put_values(std::string& json, const trace::PlantNames& names);

}  // namespace symplant::panel
