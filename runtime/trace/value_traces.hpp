// Which outputs of values a trace shows, and how often.
#pragma once

#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::trace {

/// By output of a value: the time between two looks of a trace; 0: never. Of a value with several outputs those that a
/// formula or a condition names, else the first. O(formulas).
std::vector<tables::Time> traces_of(const tables::ValueTables& values);

}  // namespace symplant::trace
