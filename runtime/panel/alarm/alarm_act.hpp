// An act of a person on alarms.
#pragma once

#include <string>

#include "symplant/tables/time.hpp"

namespace symplant::panel {

struct AlarmAct {
  tables::Time time;
  std::string json;  ///< an object
};

}  // namespace symplant::panel
