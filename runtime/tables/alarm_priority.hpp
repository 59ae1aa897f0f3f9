// How urgent an alarm is.
#pragma once

#include <cstdint>

namespace symplant::tables {

/// In the order of urgency, the least first.
enum class AlarmPriority : std::uint8_t { low, medium, high };

}  // namespace symplant::tables
