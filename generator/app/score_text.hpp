// The score of a plant, for people.
#pragma once

#include <string>

#include "model/plant_model.hpp"
#include "score/score.hpp"

namespace symplant::app {

/// "of 1377 BOOL I/O symbols 545 (40 %) paired, 1070 (78 %) accounted for: 12 constant, 80 operator, 433 data".
std::string score_text(const score::Counts& counts);

/// The symbols that are left over, as lines; with `verbose` also the stations, and events to ask for. Empty for the
/// built-in rule without `verbose`, because findings report each of its symbols.
std::string score_details(const model::PlantModel& plant, const score::Score& score, bool verbose);

}  // namespace symplant::app
