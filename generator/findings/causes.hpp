// One root cause, one finding: what merely follows from another finding becomes a related row of it.
#pragma once

#include "diag/diagnostic.hpp"
#include "model/plant_model.hpp"

namespace symplant::findings {

/// Folds findings into the one that they follow from: a symbol whose name is misspelt is missing in its device, so that
/// what is told of that device because of the missing symbol is told there ("follows from this ..."). A finding that
/// takes up a more severe one becomes as severe. What the user's settings or options leave out must be out before:
/// a root that is ignored explains nothing. O(findings), and O(devices) where something follows.
void fold_consequences(const model::PlantModel& plant, diag::Diagnostics& diagnostics);

}  // namespace symplant::findings
