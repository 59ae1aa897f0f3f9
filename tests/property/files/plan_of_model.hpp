// The plan that a plant might have come from.
#pragma once

#include "property/random_unit.hpp"

namespace symplant::property::files {

/// What conditions over the plant may name; no more is in it.
PlannedPlant plan_of(const model::PlantModel& plant);

}  // namespace symplant::property::files
