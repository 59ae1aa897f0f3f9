// Rows of all lists: symbols, internal rows, repeated names; and whose addresses they have.
#pragma once

#include <vector>

#include "model/build_plant.hpp"

namespace symplant::model {

/// Fills in lists, controllers and symbols of a plant, and what is told of rows that are no symbols. O(rows).
void collect_symbols(PlantModel& plant, const std::vector<ListInput>& lists);

}  // namespace symplant::model
