// Checks a plant model by every rule.
#pragma once

#include "diag/diagnostic.hpp"
#include "model/evidence.hpp"
#include "model/plant_model.hpp"

namespace symplant::check {

/// Adds all findings, rule by rule. O(symbols + states) for each rule.
void check_plant(const model::PlantModel& plant, const model::Evidence& evidence, diag::Diagnostics& diagnostics);

}  // namespace symplant::check
