// Sets the times of transitions that `times` of the description gives.
#pragma once

#include <string>
#include <vector>

#include "description/faults.hpp"
#include "model/matched_names.hpp"
#include "model/plant_model.hpp"
#include "model/time_formulas.hpp"

namespace symplant::model {

/// Sets times of transitions, which must be complete, and Unit::overrun. For the return of a spring without a
/// transition it adds one, after the given ones. Returns how many devices each pattern matches, in words.
/// O(units * patterns + transitions).
std::vector<std::string> resolve_times(PlantModel& plant, TimeFormulas& formulas, MadeNames& made,
                                       description::Faults& faults);

}  // namespace symplant::model
