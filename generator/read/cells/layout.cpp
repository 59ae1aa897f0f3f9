// Finds the columns of a delimited list.
#include "read/cells/layout.hpp"

#include <algorithm>

#include "address/notation.hpp"
#include "read/cells/content.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kSearchedRows = 64;
constexpr std::size_t kSampledRows = 200;

/// `Name` and `Type` without another column could be of any table.
bool names_a_gx_list(const Columns& columns, const CsvRow& row) {
  if (!columns.has(Field::name)) return false;
  if (columns.has(Field::klass) || columns.has_address()) return true;
  return columns.has(Field::type) && header_word(row.cell(columns[Field::name])) != "name";
}

/// A class and at least one other cell: a class without them is a line of a program.
bool is_classed(const CsvRow& row) {
  const auto is_filled = [](std::string_view cell) { return !cell.empty(); };
  return std::any_of(row.cells.begin(), row.cells.end(), is_class) &&
         std::count_if(row.cells.begin(), row.cells.end(), is_filled) > 1;
}

/// A layout whose header is the row that `reader` has just read.
Layout below_header(const CsvReader& reader, const CsvRow& row, char delimiter, const Columns& columns) {
  Layout layout;
  layout.columns = columns;
  layout.delimiter = delimiter;
  layout.header_line = row.line;
  layout.header.assign(row.cells.begin(), row.cells.end());
  layout.rows_begin = reader.offset();
  layout.rows_line = reader.line();
  return layout;
}

LayoutSearch gx_search(std::string_view text, char delimiter) {
  LayoutSearch search;
  std::deque<std::string> arena;
  CsvReader reader(text, delimiter, arena);
  CsvRow row;
  for (std::size_t rows = 0; rows < kSearchedRows && reader.next(row); ++rows) {
    const Columns columns = named_columns(row).columns;
    if (names_a_gx_list(columns, row)) {
      search.layout = below_header(reader, row, delimiter, columns);
      return search;
    }
    if (!search.nameless_header && !columns.has(Field::name) && columns.count() >= 3)
      search.nameless_header = row.whole;
    if (search.nameless_header || !is_classed(row)) continue;
    Layout layout;
    layout.delimiter = delimiter;
    layout.rows_begin = row.whole.begin;
    layout.rows_line = row.line;
    layout.columns = classed_columns(sample_rows(text, layout, arena));
    search.layout = std::move(layout);
    return search;
  }
  search.unclosed_quote = reader.unclosed_quote();
  return search;
}

Layout below_named(const CsvReader& reader, const CsvRow& row, char delimiter, const NamedColumns& named) {
  Layout layout = below_header(reader, row, delimiter, named.columns);
  layout.rivals = named.rivals;
  return layout;
}

/// The first row that names identifiers or addresses and another column, and holds no address itself.
std::optional<Layout> named_layout(std::string_view text, char delimiter, std::deque<std::string>& arena,
                                   std::optional<std::size_t>& unclosed) {
  CsvReader reader(text, delimiter, arena);
  CsvRow row;
  for (std::size_t rows = 0; rows < kSearchedRows && reader.next(row); ++rows) {
    NamedColumns named = named_columns(row);
    const Columns& columns = named.columns;
    if (columns.count() < 2 || !(columns.has(Field::name) || columns.has_address())) continue;
    return below_named(reader, row, delimiter, named);
  }
  unclosed = reader.unclosed_quote();
  return std::nullopt;
}

/// A list without a known header: from the first row with an address on. The row before it may be a header of which at
/// most one word is known.
Layout headless(std::string_view text, char delimiter, std::deque<std::string>& arena) {
  Layout layout;
  layout.delimiter = delimiter;
  CsvReader reader(text, delimiter, arena);
  CsvRow row;
  for (std::size_t rows = 0; rows < kSearchedRows && reader.next(row); ++rows) {
    if (std::any_of(row.cells.begin(), row.cells.end(), address::looks_like_address)) {
      layout.rows_begin = row.whole.begin;
      layout.rows_line = row.line;
      return layout;
    }
    if (row.cells.size() > 1) layout = below_named(reader, row, delimiter, named_columns(row));
  }
  Layout none;
  none.delimiter = delimiter;
  return none;
}

LayoutSearch any_search(std::string_view text, char delimiter) {
  LayoutSearch search;
  std::deque<std::string> arena;
  auto layout = named_layout(text, delimiter, arena, search.unclosed_quote);
  if (search.unclosed_quote) return search;
  if (!layout) layout = headless(text, delimiter, arena);
  const std::vector<CsvRow> rows = sample_rows(text, *layout, arena);
  if (layout->rivals) {
    if (const auto better = better_by_content(rows, *layout->rivals)) {
      layout->columns.set(layout->rivals->field, *better);
      layout->rivals.reset();
    }
  }
  if (!layout->rivals) layout->rivals = complete_by_content(rows, layout->columns);
  const bool addressed = layout->columns.has_address() || (layout->rivals && layout->rivals->field != Field::name);
  if (addressed && (layout->rivals || layout->columns.has(Field::name))) search.layout = std::move(layout);
  return search;
}

bool better(const LayoutSearch& other, const LayoutSearch& best) {
  if (best.layout) return false;
  return other.layout || (other.nameless_header && !best.nameless_header);
}

template <class Search>
LayoutSearch search_all(std::string_view text, Search search) {
  const char likely = sniff_delimiter(text);
  LayoutSearch best = search(text, likely);
  for (const char delimiter : {'\t', ';', ','}) {
    if (best.layout) return best;
    if (delimiter == likely) continue;
    LayoutSearch other = search(text, delimiter);
    if (better(other, best)) best = std::move(other);
  }
  return best;
}

/// The column of the row that a header names; kNoColumn if there is none.
std::size_t column_of(const CsvRow& row, const std::string& header) {
  const std::string word = header_word(header);
  const auto is_it = [&](std::string_view cell) { return cell == header || header_word(cell) == word; };
  const auto found = std::find_if(row.cells.begin(), row.cells.end(), is_it);
  return found == row.cells.end() ? kNoColumn : static_cast<std::size_t>(found - row.cells.begin());
}

/// Whether all headers of the map are in the row; their columns then replace those of `columns`.
bool apply(const ColumnMap& map, const CsvRow& row, Columns& columns) {
  for (const GivenColumn& given : map.columns) {
    const std::size_t column = given.header.empty() ? given.number - 1 : column_of(row, given.header);
    if (column == kNoColumn) return false;
    if (given.field == Field::vendor_address) columns.set(Field::iec_address, kNoColumn);
    columns.set(given.field, column);
  }
  return true;
}

}  // namespace

std::vector<CsvRow> sample_rows(std::string_view text, const Layout& layout, std::deque<std::string>& arena) {
  std::vector<CsvRow> rows;
  CsvReader reader(text, layout.delimiter, arena, layout.rows_begin, layout.rows_line);
  CsvRow row;
  while (rows.size() < kSampledRows && reader.next(row)) {
    if (!row.blank()) rows.push_back(row);
  }
  return rows;
}

LayoutSearch find_gx_layout(std::string_view text) { return search_all(text, gx_search); }
LayoutSearch find_any_layout(std::string_view text) { return search_all(text, any_search); }

std::optional<Layout> below_header_with(std::string_view text, std::span<const std::string_view> words) {
  std::deque<std::string> arena;
  for (const char delimiter : {'\t', ';', ','}) {
    CsvReader reader(text, delimiter, arena);
    CsvRow row;
    for (std::size_t rows = 0; rows < kSearchedRows && reader.next(row); ++rows) {
      if (row.cells.size() < words.size()) continue;
      const auto has = [&](std::string_view word) {
        return std::any_of(row.cells.begin(), row.cells.end(),
                           [&](std::string_view cell) { return header_word(cell) == word; });
      };
      if (std::all_of(words.begin(), words.end(), has))
        return below_header(reader, row, delimiter, named_columns(row).columns);
    }
  }
  return std::nullopt;
}

base::Result<Layout, std::string> given_layout(std::string_view text, const ColumnMap& map) {
  const bool by_header = std::any_of(map.columns.begin(), map.columns.end(),
                                     [](const GivenColumn& given) { return !given.header.empty(); });
  std::deque<std::string> arena;
  for (const char delimiter : {sniff_delimiter(text), '\t', ';', ','}) {
    CsvReader reader(text, delimiter, arena);
    CsvRow row;
    for (std::size_t rows = 0; rows < kSearchedRows && reader.next(row); ++rows) {
      Columns columns = named_columns(row).columns;
      const bool is_header = columns.count() >= 2;
      if (!(by_header || is_header) || !apply(map, row, columns)) continue;
      return below_header(reader, row, delimiter, columns);
    }
  }
  if (!by_header) {
    Layout layout;
    layout.delimiter = sniff_delimiter(text);
    apply(map, {}, layout.columns);
    return layout;
  }
  std::string wanted;
  for (const GivenColumn& given : map.columns) {
    if (!given.header.empty()) wanted.append(wanted.empty() ? "`" : ", `").append(given.header).append("`");
  }
  return "no row of the first " + std::to_string(kSearchedRows) + " has the header " + wanted +
         "; write the headers as the table has them, or give the numbers of the columns";
}

}  // namespace symplant::read
