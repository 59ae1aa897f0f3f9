// An alarm as the description gives it.
#pragma once

#include <optional>
#include <string>

#include "symplant/tables/alarm_priority.hpp"

namespace symplant::description {

struct GivenAlarm {
  std::string of;  ///< an operation, a value, or a pattern
  std::optional<tables::AlarmPriority> priority = {};
};

}  // namespace symplant::description
