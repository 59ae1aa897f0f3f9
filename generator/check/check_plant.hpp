// Checks a plant model by every rule.
#pragma once

#include <cstddef>

#include "diag/diagnostic.hpp"
#include "model/evidence.hpp"
#include "model/plant_model.hpp"

namespace symplant::check {

/// Adds all findings, rule by rule in the order of the table; `threads` rules run at once. O(symbols + states) for each
/// rule.
void check_plant(const model::PlantModel& plant, const model::Evidence& evidence, std::size_t threads,
                 diag::Diagnostics& diagnostics);
/// The same with one thread, or as many as many symbols are worth.
void check_plant(const model::PlantModel& plant, const model::Evidence& evidence, diag::Diagnostics& diagnostics);

}  // namespace symplant::check
