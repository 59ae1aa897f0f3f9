// Compares the devices of two plants, and what plants have besides devices.
#pragma once

#include "diff/symbols.hpp"

namespace symplant::diff {

/// Sets `devices` and `plant` of the result. Conditions, tasks and states of the old model are compared under their new
/// names. O(n log n) in the parts of both models.
void compare_models(const model::PlantModel& before, const model::PlantModel& after, const SymbolPairs& pairs,
                    Difference& result);

}  // namespace symplant::diff
