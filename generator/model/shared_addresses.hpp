// Symbols that stand on one address.
#pragma once

#include "model/plant_model.hpp"

namespace symplant::model {

/// Finds them, controller by controller, and says which one leads the others: of events the one that a unit moves, else
/// the first. Two events that different units move are recorded in `moved_twice`. O(symbols).
void find_shared_addresses(PlantModel& plant);

}  // namespace symplant::model
