// Reads the rows of a delimited text, as views into it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/forward_search.hpp"
#include "text/source_file.hpp"

namespace symplant::read {

/// The most cells of a row of a list; more are ignored. No list has that many, and a file of delimiters must not fill
/// the memory.
inline constexpr std::size_t kMaxCells = 4096;

/// The delimiter (TAB, `;` or `,`) that divides the first rows most evenly, counted outside quotes; `,` if none occurs.
char sniff_delimiter(std::string_view text);

struct CsvRow {
  std::vector<std::string_view> cells;  ///< without quotes and blanks around
  std::uint32_t line = 0;               ///< the line at which the row begins, counted from 1
  text::Span whole;                     ///< its bytes, without its line end
  std::optional<text::Span> stray;      ///< the first text after a closing quote

  /// The cell of that column; empty if the row is shorter.
  std::string_view cell(std::size_t column) const { return column < cells.size() ? cells[column] : std::string_view{}; }
  bool blank() const;
};

/// Reads row by row. A cell may be quoted, with `""` for a quote and line ends inside; a quote within a cell
/// that does not begin with a quote is an ordinary character. Rows end at LF, CRLF or CR. O(text) over all rows.
class CsvReader {
 public:
  /// Begins at `offset`, in line `line`. Cells with `""` are written to `arena`; the others point into `text`. A row
  /// has `most_cells` at most.
  CsvReader(std::string_view text, char delimiter, std::deque<std::string>& arena, std::size_t offset = 0,
            std::uint32_t line = 1, std::size_t most_cells = kMaxCells)
      : text_(text),
        delimiter_(delimiter),
        most_cells_(most_cells),
        arena_(arena),
        at_(offset),
        line_(line),
        ends_(text, delimiter, '\n', '\r') {}

  /// False at the end, and if a quote is not closed. An empty line is a row of one empty cell.
  bool next(CsvRow& row);

  /// The offset of the quote that is never closed.
  std::optional<std::size_t> unclosed_quote() const { return unclosed_quote_; }
  /// The offset of the next row.
  std::size_t offset() const { return at_; }
  std::uint32_t line() const { return line_; }

 private:
  bool is_blank(char c) const { return c == ' ' || (c == '\t' && delimiter_ != '\t'); }
  void skip_blanks();
  std::string_view plain_cell();
  bool quoted_cell(CsvRow& row, std::string_view& cell);
  void end_row();

  std::string_view text_;
  char delimiter_;
  std::size_t most_cells_;
  std::deque<std::string>& arena_;
  std::size_t at_;
  std::uint32_t line_;
  base::ForwardSearch ends_;  ///< of cells without quotes
  std::optional<std::size_t> unclosed_quote_;
};

}  // namespace symplant::read
