// Views of the custom behavior classes: for the code that calls them, and for their files as first written.
#pragma once

#include <string>
#include <vector>

#include "emit/render.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// One view for each behavior, by index: texts `behaviour`, `base`, `behaviour_file`, list `devices`.
/// `classes` are the names of the types. O(devices with a behavior).
std::vector<View> behaviour_views(const lower::EngineTables& tables, const model::PlantModel& plant,
                                  const std::vector<std::string>& classes);

}  // namespace symplant::emit
