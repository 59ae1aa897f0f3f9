// Malfunctions that a scenario starts and stops.
#pragma once

#include "property/dice.hpp"
#include "property/files/file_case.hpp"
#include "support/reference/world.hpp"

namespace symplant::property::files {

/// Adds `stop` and `start`, or neither; with `too_many` perhaps more ordinary malfunctions than there may be.
void add_starts(Dice& dice, const model::PlantModel& plant, const reference::World& world, bool too_many, Step& step);

/// For a plant of add_restless_malfunctions().
std::vector<Step> steps_that_freeze_malfunctions(Dice& dice);

}  // namespace symplant::property::files
