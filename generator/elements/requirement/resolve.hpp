// Resolves the requirements of the description.
#pragma once

#include "description/faults.hpp"
#include "model/condition_reader.hpp"
#include "model/matched_names.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Fills PlantModel::requirements. All units must be derived. O(requirements * units).
void resolve_requirements(PlantModel& plant, ConditionReader& conditions, MadeNames& made, description::Faults& faults);

}  // namespace symplant::model
