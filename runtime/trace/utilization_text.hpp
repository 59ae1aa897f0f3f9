// The utilization of a plant as text: JSON for programs and the page, and comma-separated values.
#pragma once

#include <cstdint>
#include <string>

#include "symplant/trace/utilization.hpp"

namespace symplant::trace {

/// The first cells of a table of utilization_csv().
inline constexpr const char* kUtilizationHead = "kind,name,measure,of,";

/// What is known of all devices, tracks, places and exits until `now`, by their names: an object. O(plant).
std::string utilization_json(const Utilization& utilization, tables::Time now);

/// The same for tables of many devices: arrays of numbers in the order of the plant's description. O(plant).
/// `with_malfunctions`: false hides the times under a malfunction; they are 0 in arrays.
std::string utilization_table_json(const Utilization& utilization, tables::Time now, bool with_malfunctions = true);

/// One device as in utilization_json(). O(states and transitions of the device).
std::string device_use_json(const Utilization& utilization, std::uint32_t unit, tables::Time now,
                            bool with_malfunctions = true);

/// One line for each number: kind, name, measure, of, time and share, count, least, mean, greatest and last time. Times
/// are in seconds. A text that begins like a formula gets an apostrophe. O(plant).
std::string utilization_csv(const Utilization& utilization, tables::Time now, bool with_malfunctions = true);

}  // namespace symplant::trace
