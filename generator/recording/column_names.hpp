// What the headers of columns say.
#pragma once

#include <string_view>

#include "recording/table_times.hpp"

namespace symplant::recording {

enum class ColumnRole : unsigned char {
  other,
  time,
  date,      ///< a date, or a date with time of day
  symbol,    ///< in each row the name of a symbol
  value,     ///< in each row a value
  validity,  ///< in each row whether the value counts
};

struct ColumnHeader {
  ColumnRole role = ColumnRole::other;
  TimeForm form = TimeForm::unknown;  ///< of times, if the header has a unit
};

/// `Time [ms]`, `t/s`, `timestamp_us`, `Zeit (s)`, `VarName`. O(header).
ColumnHeader column_header(std::string_view header);

/// A column of a Mitsubishi logging file that is no symbol: `INTERVAL[us]`, `INDEX`, `STEP NO.`, `PROGRAM NAME`,
/// `Trigger`.
bool is_logging_column(std::string_view header);

}  // namespace symplant::recording
