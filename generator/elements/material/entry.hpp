// Reads `material` of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "description/json_entry.hpp"
#include "description/plant_source.hpp"
#include "elements/material/given.hpp"

namespace symplant::description {

/// The value of `material`. Faults of shape, lengths, speeds and durations are reported; names are not resolved.
GivenMaterial material_entry(const nlohmann::json& value, ShapeFaults& faults);

/// Sorts kinds, tracks and places as they are written: their order has a meaning.
void sort_as_written(GivenMaterial& material, const PlantSource& source);

}  // namespace symplant::description
