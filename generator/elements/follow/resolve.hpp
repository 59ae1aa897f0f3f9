// Resolves the conditions that symbols follow.
#pragma once

#include "description/faults.hpp"
#include "model/condition_reader.hpp"
#include "model/matched_names.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Fills in Follow::condition; an entry with a fault is left out. All units must be derived. O(follows).
void resolve_follows(PlantModel& plant, ConditionReader& conditions, MadeNames& made, description::Faults& faults);

}  // namespace symplant::model
