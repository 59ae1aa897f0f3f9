// Lowers times that may be random.
#pragma once

#include "description/duration.hpp"
#include "lower/engine_tables.hpp"

namespace symplant::lower {

/// A fixed time, or a negative number that refers to EngineTables::random_times. A random time that is missing there is
/// added. O(random times).
tables::Time lower_time(const description::Duration& duration, EngineTables& tables);

}  // namespace symplant::lower
