// Recognizes sensors of parts by their names.
#pragma once

#include <string_view>

#include "model/plant_model.hpp"

namespace symplant::model {

/// Whether a level or word of a symbol's name is one that photo-eyes, presence and pallet sensors have: PE3, PART,
/// PALLET, PRESENT, ... O(name).
bool looks_like_part_sensor(std::string_view name);

/// Whether a device, a condition, a part or a symbol on its address drives an event.
bool is_driven(const PlantModel& plant, const Symbol& symbol);

}  // namespace symplant::model
