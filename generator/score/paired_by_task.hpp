// Which symbols the built-in naming rule pairs: by task, so that a device of many symbols raises nothing.
#pragma once

#include <vector>

#include "model/plant_model.hpp"

namespace symplant::score {

/// One value for each symbol of the plant: whether it is an operation that moves an event, or an event that an
/// operation moves (docs/checking.md, "The score"). O(symbols and transitions).
std::vector<bool> paired_by_task(const model::PlantModel& plant);

}  // namespace symplant::score
