// Proposes a material flow for a list: tracks with the inputs that look like sensors of parts.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/plant_model.hpp"

namespace symplant::emit {

/// A value of `material`; null if no undriven input looks like a sensor of parts, or the plant has material. One track
/// for each process, with the positions to be filled in. O(symbols).
nlohmann::ordered_json proposed_material(const model::PlantModel& plant);

/// Whether all symbols of a unit are sensors that the proposal takes: then it is not a device.
bool is_only_part_sensors(const model::PlantModel& plant, const model::Unit& unit);

}  // namespace symplant::emit
