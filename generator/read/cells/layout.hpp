// Finds the columns of a delimited list: by its header, by its cells, or as the user says.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "read/cells/column_map.hpp"
#include "read/cells/columns.hpp"
#include "text/source_file.hpp"

namespace symplant::read {

struct Layout {
  Columns columns;
  char delimiter = ',';
  std::optional<std::uint32_t> header_line;  ///< nothing: the list has no header
  std::vector<std::string> header;           ///< its cells; empty: the list has no header
  std::size_t rows_begin = 0;                ///< offset of the first row after header and titles
  std::uint32_t rows_line = 1;
  std::optional<Rivals> rivals;  ///< two columns for one field; their cells do not decide either
};

/// The result of examining the first rows.
struct LayoutSearch {
  std::optional<Layout> layout;
  std::optional<text::Span> nameless_header;  ///< a header without a column of identifiers
  std::optional<std::size_t> unclosed_quote;  ///< the search ended at a quote that is never closed
};

/// A list of global variables: a header that names identifiers and classes or addresses, else a class column
/// (VAR_GLOBAL ...), with each delimiter. O(first rows).
LayoutSearch find_gx_layout(std::string_view text);

/// Any table of symbols: a header that names identifiers or addresses, the rest by the content of the cells; without
/// such a header, all by content. Nothing without a column of names or without one of addresses. O(first rows).
LayoutSearch find_any_layout(std::string_view text);

/// The layout below the first row that has a cell for each of `words` (as header_word() makes them), with the columns
/// that it names. O(first rows).
std::optional<Layout> below_header_with(std::string_view text, std::span<const std::string_view> words);

/// The columns that the user gives, the others by their header. The error is a message: a column that the table does
/// not have.
base::Result<Layout, std::string> given_layout(std::string_view text, const ColumnMap& map);

/// The first rows of the list, without blank ones. Cells with `""` are written to `arena`.
std::vector<CsvRow> sample_rows(std::string_view text, const Layout& layout, std::deque<std::string>& arena);

}  // namespace symplant::read
