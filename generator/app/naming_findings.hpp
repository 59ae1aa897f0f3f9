// Findings about the parts of a naming rule that need the plant's symbols.
#pragma once

#include "diag/diagnostic.hpp"
#include "model/plant_model.hpp"
#include "naming/load.hpp"

namespace symplant::app {

/// Adds an error for each link that cannot be used, and a warning for each rule and archetype that matches nothing. The
/// plant must have a custom naming rule, with these parts.
void add_naming_findings(const model::PlantModel& plant, const naming::LoadedNaming& parts,
                         diag::Diagnostics& diagnostics);

}  // namespace symplant::app
