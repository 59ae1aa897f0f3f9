// Parts that a scenario puts and takes, and conditions that name parts.
#pragma once

#include <string>

#include "property/dice.hpp"
#include "property/files/file_case.hpp"
#include "support/reference/world.hpp"

namespace symplant::property::files {

/// Adds `put` and `take` to some steps. Many find room or a part in this world, some do not.
void add_hands(Dice& dice, const model::Material& material, const reference::World& world, Step& step);

/// Steps while tracks have an instant every nanosecond until they freeze.
std::vector<Step> steps_that_freeze_tracks(Dice& dice, const model::Material& material);

/// Such as `CV1.part`, `not CV1.raw` or `CV1.parts < 2`.
std::string condition_of_parts(Dice& dice, const model::Material& material);

/// Whether a condition has an atom on parts of the plant.
bool names_parts(const std::string& condition, const model::Material& material);

}  // namespace symplant::property::files
