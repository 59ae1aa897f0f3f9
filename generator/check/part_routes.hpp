// Where parts can come in a material flow.
#pragma once

#include <vector>

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::check {

/// For each location whether a part of a source can come there, whatever conditions hold. O(routes).
std::vector<bool> locations_with_parts(const model::Material& material);

/// The entry of a track, and of a place, in the description.
description::Pointer track_pointer(const model::PlantModel& plant, const model::Track& track);
description::Pointer place_pointer(const model::PlantModel& plant, const model::Place& place);

}  // namespace symplant::check
