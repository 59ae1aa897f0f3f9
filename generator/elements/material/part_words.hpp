// Recognizes sensors of parts by their names.
#pragma once

#include "model/plant_model.hpp"

namespace symplant::model {

/// Whether the device or the task of a symbol's name has a word of photo-eyes, presence and pallet sensors: PE3, PART,
/// PALLET, PRESENT, ... O(name).
bool looks_like_part_sensor(const Symbol& symbol);

/// Whether a device, a condition, a part or the leading symbol on its address drives an event, or a constant sets it.
bool is_driven(const PlantModel& plant, const Symbol& symbol);

}  // namespace symplant::model
