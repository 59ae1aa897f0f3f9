// Reads the alarms of the description.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "elements/alarm/given.hpp"

namespace symplant::description {

/// The member `alarms` of a description that the schema has checked; none if it is missing. O(alarms).
std::vector<GivenAlarm> alarms_of(const nlohmann::json& root);

}  // namespace symplant::description
