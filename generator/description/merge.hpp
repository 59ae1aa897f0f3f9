// Merges the descriptions of files.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "description/plant_source.hpp"

namespace symplant::description {

/// The value of a description, and where it and its members are written.
struct Written {
  nlohmann::json& value;
  Origin& origin;
};

/// Adds what another description gives in addition; what the first one gives stays. Objects are merged key by key at
/// every depth, unless they are one of several forms of a value, such as a random time. Requirements and malfunctions
/// are merged by name, links and programs by controller. `schema` is that of plant.json. O(the other description).
void merge(Written into, const nlohmann::json& other, const Origin& other_origin, const nlohmann::json& schema);

}  // namespace symplant::description
