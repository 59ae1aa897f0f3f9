// When a time without a reading is a gap.
#pragma once

#include "symplant/tables/time.hpp"

namespace symplant::recording {

/// Whether readings are so far apart that some are missing: more than three intervals, as one may be late.
constexpr bool is_gap(tables::Time distance, tables::Time interval) { return distance > 3 * interval; }

}  // namespace symplant::recording
