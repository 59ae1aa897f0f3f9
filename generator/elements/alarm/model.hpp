// The alarms of a plant with resolved names.
#pragma once

#include <cstdint>

#include "symplant/tables/alarm_priority.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::model {

/// What a program shows a person when something is wrong: an operation, or a value of the plant that depends on one. It
/// is on if it is not 0, or, for an inverted symbol, if its bit is off.
struct Alarm {
  std::uint32_t symbol = tables::kNone;  ///< an operation, or kNone
  std::uint32_t value = tables::kNone;   ///< then a value
  tables::AlarmPriority priority = tables::AlarmPriority::high;

  friend bool operator==(const Alarm&, const Alarm&) = default;
};

}  // namespace symplant::model
