// Reads `material` of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "description/json_entry.hpp"
#include "elements/material/given.hpp"

namespace symplant::description {

/// The value of `material`. Faults of shape, lengths, speeds and durations are reported; names are not resolved.
GivenMaterial material_entry(const nlohmann::json& value, ShapeFaults& faults);

/// Sorts kinds, tracks and places as the text of the plant.json has them: their order has a meaning.
void sort_as_written(GivenMaterial& material, std::string_view text);

}  // namespace symplant::description
