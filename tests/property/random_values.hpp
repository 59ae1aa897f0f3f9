// Random values and signals for a drawn plant: every kind, formulas over the plant and each other, jumps, limits, and
// results that are not finite.
#pragma once

#include <string>
#include <vector>

#include "property/dice.hpp"
#include "property/plant_text.hpp"

namespace symplant::property {

/// Adds values, signals and rows for them to a plant without values. `model`: of that plant.
void add_random_values(Dice& dice, PlantText& text, const model::PlantModel& model);

/// Some times of transitions are computed by formulas.
void let_times_read_values(Dice& dice, PlantText& text);
/// Some followers are switches with hysteresis.
void let_followers_switch(Dice& dice, PlantText& text);
/// Malfunctions that hold parameters and distort signals.
void add_malfunctions_of_values(Dice& dice, PlantText& text);
/// Lets values give the speed of drives whose speed is not constant.
void let_drives_read_values(Dice& dice, PlantText& text);
/// Lets conditions compare values.
void let_conditions_read_values(Dice& dice, PlantText& text);

/// A value that can be set, in some other case of its letters at times; "none" without one.
std::string random_settable_value(Dice& dice, const description::Description& description);
/// From a small grid, so that equal numbers are frequent.
double random_value_number(Dice& dice);

}  // namespace symplant::property
