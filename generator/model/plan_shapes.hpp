// What the devices look like in the panel's plan.
#pragma once

#include <vector>

#include "model/plant_model.hpp"
#include "symplant/tables/shape.hpp"

namespace symplant::model {

/// A shape for each unit: the one that `view` of the description gives, else one guessed from the words of its name,
/// then from those of its states, and from how it is actuated. O(length of all names + entries of `view`).
std::vector<tables::Shape> plan_shapes(const PlantModel& plant);

}  // namespace symplant::model
