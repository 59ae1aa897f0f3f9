// Values, signals and `plain` of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "property/files/said.hpp"

namespace symplant::property::files {

/// Adds `values`, `signals` and `plain` to a plant.json, if there are any.
void add_values(nlohmann::json& said, const description::Description& description, Sayer& sayer, Counts& counts);

}  // namespace symplant::property::files
