// Random plants whose names are read by a custom naming rule: pairs, sensors, fan-out, links and every archetype.
#pragma once

#include <string_view>

#include "name/naming.hpp"
#include "property/dice.hpp"
#include "property/plant_text.hpp"

namespace symplant::property {

/// The naming rules of PlantText::naming, by name: `cell`, and `sequence`, in which digits are sequence numbers.
name::Naming naming_of(std::string_view name);

/// The same plant for the same dice, everywhere.
PlantText cell_plant(Dice& dice);

}  // namespace symplant::property
