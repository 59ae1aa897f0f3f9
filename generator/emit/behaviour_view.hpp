// The user's own classes: what calls them, and their files as they are first written.
#pragma once

#include <string>
#include <vector>

#include "emit/render.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// A view a behaviour, in the order of their places: texts `behaviour`, `base`, `behaviour_file`, list `devices`.
/// `classes` are the types' names. O(devices with a behaviour).
std::vector<View> behaviour_views(const lower::EngineTables& tables, const model::PlantModel& plant,
                                  const std::vector<std::string>& classes);

}  // namespace symplant::emit
