// A plan that a given plant could come from.
#pragma once

#include "property/random_unit.hpp"

namespace symplant::property::files {

/// Contains only what conditions over the plant may name.
PlannedPlant plan_of(const model::PlantModel& plant);

}  // namespace symplant::property::files
