// Why a value does not fit a schema, in words.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "symplant/json/location.hpp"

namespace symplant::json {

/// Walks schema and value side by side and tells, for each value at fault, what is there and what is wanted; the first
/// 100. Knows the keywords that Schema's own schemas keep to. O(value).
std::vector<Fault> explain(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace symplant::json
