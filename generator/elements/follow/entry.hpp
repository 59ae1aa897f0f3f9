// Reads `follow` of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "elements/follow/given.hpp"

namespace symplant::description {

/// The object `follow`.
std::vector<GivenFollow> follow_entries(const nlohmann::json& object);

}  // namespace symplant::description
