// Resolves the values of the description.
#pragma once

#include "description/faults.hpp"
#include "model/condition_reader.hpp"
#include "model/matched_names.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Makes PlantModel::values with names and outputs, one for each device that `for` matches, so that conditions can name
/// them. The units must have their states; the rest comes from resolve_values(). O(values * units).
void name_values(PlantModel& plant, description::Faults& faults);

/// Resolves formulas and jumps; a value with a fault is left as a parameter, so that others can name it. O(formulas).
void resolve_values(PlantModel& plant, ConditionReader& conditions, MadeNames& made, description::Faults& faults);

/// Indexes of the values that are computed from others, each after those that it reads; equals in the order of the
/// file. Reports values that depend on themselves. O(formulas).
std::vector<std::uint32_t> value_order(const PlantModel& plant, description::Faults* faults);

}  // namespace symplant::model
