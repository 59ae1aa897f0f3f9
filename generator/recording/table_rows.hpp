// The rows of a table of another tool.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "read/cells/csv.hpp"

namespace symplant::recording {

/// The most columns of a table; a file of separators must not fill the memory.
inline constexpr std::size_t kMostColumns = 1'000'000;

/// Reads row by row. A row in which text follows a closing quote is not quoted: `"DB1".x` is a name of a PLC. O(text)
/// over all rows.
class TableRows {
 public:
  TableRows(std::string_view text, char delimiter);

  /// False at the end, and if a quote is not closed. Cells are valid until the next call.
  bool next();

  const std::vector<std::string_view>& cells() const { return row_.cells; }
  /// The cell of that column; empty if the row is shorter.
  std::string_view cell(std::size_t column) const { return row_.cell(column); }
  bool blank() const { return row_.blank(); }
  /// The line at which the row begins, counted from 1.
  std::uint32_t line() const { return row_.line; }
  /// The row is the last one, and has no line end.
  bool is_open() const { return row_.whole.end == text_.size(); }
  bool has_unclosed_quote() const { return csv_.unclosed_quote().has_value(); }
  /// The line end after the quote that is not closed is missing, too.
  bool is_cut_in_quote() const;

 private:
  void split_unquoted();

  std::string_view text_;
  char delimiter_;
  std::deque<std::string> arena_;
  read::CsvReader csv_;
  read::CsvRow row_;
};

}  // namespace symplant::recording
