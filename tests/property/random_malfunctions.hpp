// Random malfunctions for a drawn plant.
#pragma once

#include <string>

#include "property/dice.hpp"
#include "property/plant_text.hpp"

namespace symplant::property {

/// `model`: of the plant as it is without malfunctions.
void add_random_malfunctions(Dice& dice, PlantText& text, const model::PlantModel& model);

/// A malfunction as actions name it (malfunction_names.hpp), written or ordinary.
std::string random_malfunction(Dice& dice, const model::PlantModel& model);

}  // namespace symplant::property
