// The material flow of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "property/files/said.hpp"

namespace symplant::property::files {

/// The key `material`. An entry with `of` is written with `for`, and with its texts in braces.
nlohmann::json material_json(const description::GivenMaterial& material, Sayer& sayer, Counts& counts);

}  // namespace symplant::property::files
