// Explains why a value does not match a schema.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "symplant/json/location.hpp"

namespace symplant::json {

/// Compares a value with a schema: returns the first 100 faults, each with what was expected and what was found.
/// Supports the keywords listed at class Schema. O(value).
std::vector<Fault> explain(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace symplant::json
