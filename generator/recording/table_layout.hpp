// Where a table of another tool has its times, names and values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/reading.hpp"
#include "recording/table_times.hpp"

namespace symplant::recording {

/// A column of times, and the columns of values that it is for.
struct TimeColumn {
  std::size_t column = 0;
  std::optional<std::size_t> date;    ///< the column of dates, if `column` has times of day only
  TimeForm form = TimeForm::unknown;  ///< by the header
  std::vector<std::size_t> values;
};

/// In each row the name of a symbol and its value.
struct LongColumns {
  std::size_t symbol = 0;
  std::size_t value = 0;
  std::optional<std::size_t> validity;
};

struct TableLayout {
  char delimiter = ',';
  std::uint32_t header_line = 0;
  std::uint32_t data_line = 0;        ///< of the first row of values
  std::vector<std::string> names;     ///< by column
  std::vector<TimeColumn> times;      ///< at least one; several: pairs
  std::optional<LongColumns> by_row;  ///< of a long table
  std::string error;                  ///< `FILE:3: ...`; empty: the table was found
};

/// Finds the separator, the header and the first row of values. Lines before the header are skipped. O(columns * rows)
/// of the first rows.
TableLayout find_layout(std::string_view text, const std::string& name, const ReadOptions& options);

}  // namespace symplant::recording
