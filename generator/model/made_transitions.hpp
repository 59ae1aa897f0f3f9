// Finds the entries of patterns that a unit lacks, because they make names that the plant lacks.
#pragma once

#include "description/faults.hpp"
#include "model/matched_names.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Whether conditions of transitions under patterns have names in braces.
bool makes_names(const description::Description& description);

/// Fills Unit::left_out with the transitions of patterns whose conditions name what the plant lacks. The states of all
/// units must be known. O(symbols and conditions).
void leave_out_unknown(PlantModel& plant, MadeNames& made, const description::Faults& faults);

/// Reports the names that entries make and the plant lacks: as errors if every device that the pattern matches lacks
/// them, whether it takes the entry or overrides it.
void report_made_names(const PlantModel& plant, const MadeNames& made, description::Faults& faults);

}  // namespace symplant::model
