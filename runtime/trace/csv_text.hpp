// Comma-separated values.
#pragma once

#include <string>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::trace {

/// A text as a cell. One that begins like a formula gets an apostrophe, so that spreadsheets do not compute it.
std::string csv_cell(std::string_view text);
/// A time as a cell, in seconds, exact; `-` if it is negative.
std::string csv_seconds(tables::Time time);

}  // namespace symplant::trace
