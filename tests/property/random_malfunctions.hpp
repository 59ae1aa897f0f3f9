// Random malfunctions for a drawn plant.
#pragma once

#include <string>

#include "property/dice.hpp"
#include "property/plant_text.hpp"

namespace symplant::property {

/// `model`: of the plant as it is without malfunctions.
void add_random_malfunctions(Dice& dice, PlantText& text, const model::PlantModel& model);

/// Malfunctions that start and end without end, most of them so often that they are frozen, on a few symbols.
void add_restless_malfunctions(Dice& dice, PlantText& text);
bool has_restless_malfunctions(const model::PlantModel& model);

/// A malfunction as actions name it (malfunction_names.hpp), written or ordinary.
std::string random_malfunction(Dice& dice, const model::PlantModel& model);

}  // namespace symplant::property
