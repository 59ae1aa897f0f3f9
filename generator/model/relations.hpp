// Resolves the relations between units: conditions, disables.
#pragma once

#include "description/faults.hpp"
#include "model/condition_reader.hpp"
#include "model/matched_names.hpp"
#include "model/plant_model.hpp"
#include "model/time_formulas.hpp"

namespace symplant::model {

/// Fills in Unit::conditions, first_input, disables and values. All units must be derived. O(symbols and description).
void add_relations(PlantModel& plant, ConditionReader& conditions, TimeFormulas& times, MadeNames& made,
                   description::Faults& faults);

}  // namespace symplant::model
