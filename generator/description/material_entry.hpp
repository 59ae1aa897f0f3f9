// Reads `material` of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "description/json_entry.hpp"
#include "description/material.hpp"

namespace symplant::description {

/// The value of `material`. Faults of shape, lengths, speeds and durations are reported; names are not resolved.
GivenMaterial material_entry(const nlohmann::json& value, ShapeFaults& faults);

/// A length of at most 1 km in um; nothing, and a fault, if the text is none.
std::optional<std::int64_t> length_of(const std::string& text, const Pointer& here, ShapeFaults& faults);

}  // namespace symplant::description
