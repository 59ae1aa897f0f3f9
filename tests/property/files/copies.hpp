// Devices that are equal except for their names, and requirements for each: what patterns with braces are for.
#pragma once

#include "property/dice.hpp"
#include "property/plant_text.hpp"

namespace symplant::property::files {

/// Adds them to some plants.
void add_copies(Dice dice, PlantText& plant);

}  // namespace symplant::property::files
