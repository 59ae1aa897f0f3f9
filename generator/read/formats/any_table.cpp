// Reads any table of symbols: columns by the words of its header, by the content of its cells, or as the user says.
#include <fmt/format.h>

#include <algorithm>

#include "read/formats.hpp"
#include "read/formats/table_formats.hpp"
#include "read/rules/ambiguous_columns.hpp"
#include "read/rules/missing_column.hpp"
#include "read/rules/unclosed_quote.hpp"
#include "read/rules/unknown_format.hpp"
#include "text/utf8.hpp"

namespace symplant::read {

namespace {

constexpr int kByHeader = 35;
constexpr int kByContent = 20;
constexpr int kRivals = 35;
constexpr int kWithoutAddress = 25;  ///< a name and a type

/// Columns of names and addresses; else, by the words of a header, one of names.
LayoutSearch find_layout(std::string_view text) {
  LayoutSearch search = find_any_layout(text);
  if (search.layout || search.unclosed_quote) return search;
  LayoutSearch named = find_gx_layout(text);
  const bool found = named.layout && named.layout->header_line && !named.layout->columns.has(Field::klass);
  return found ? std::move(named) : std::move(search);
}

int any_table_likelihood(std::string_view text) {
  const LayoutSearch search = find_layout(text);
  if (!search.layout) return 0;
  if (search.layout->rivals) return kRivals;
  if (!search.layout->columns.has_address()) return kWithoutAddress;
  return search.layout->header_line ? kByHeader : kByContent;
}

/// "column 1 `Tag` (`VALVE1`, `VALVE2`)".
std::string shown(const Layout& layout, const std::vector<CsvRow>& rows, std::size_t column) {
  constexpr std::size_t kExamples = 2;
  std::string text = fmt::format("column {}", column + 1);
  if (column < layout.header.size()) text += fmt::format(" `{}`", layout.header[column]);
  std::string examples;
  for (const std::string_view cell : sample_cells(rows, column)) {
    if (examples.size() > 80 || std::count(examples.begin(), examples.end(), '`') == 2 * kExamples) break;
    examples += fmt::format("{}`{}`", examples.empty() ? "" : ", ", text::first_code_points(cell, 40));
  }
  return text + " (" + examples + ")";
}

void report_rivals(const Reading& reading, const Layout& layout) {
  std::deque<std::string> arena;
  const std::vector<CsvRow> rows = sample_rows(reading.source->text(), layout, arena);
  const Rivals& rivals = *layout.rivals;
  const std::string_view what = rivals.field == Field::name ? "identifiers" : "addresses";
  const std::string_view word = rivals.field == Field::name ? "name" : "address";
  const std::string advice =
      reading.options.described
          ? fmt::format("write `\"columns\": {{ \"{}\": {} }}` or {} in plant.json", word, rivals.first + 1,
                        rivals.second + 1)
          : fmt::format("use `--columns {}={}` or `--columns {}={}`", word, rivals.first + 1, word, rivals.second + 1);
  const std::size_t line = layout.header_line ? layout.rows_begin == 0 ? 0 : layout.rows_begin - 1 : layout.rows_begin;
  reading.diagnostics.add(kAmbiguousColumns,
                          fmt::format("two columns serve as {} equally well: {} and {}; {}", what,
                                      shown(layout, rows, rivals.first), shown(layout, rows, rivals.second), advice),
                          {reading.source, reading.source->span_of(reading.source->line_at(line))});
}

std::optional<Layout> any_table_layout(const Reading& reading) {
  const std::string_view text = reading.source->text();
  const text::Span first = reading.source->span_of(reading.source->line_at(0));
  if (!reading.options.columns.columns.empty()) {
    auto given = given_layout(text, reading.options.columns);
    if (given) return std::move(*given);
    reading.diagnostics.add(kMissingColumn, given.error(), {reading.source, first});
    return std::nullopt;
  }
  LayoutSearch search = find_layout(text);
  if (search.layout && !search.layout->rivals) return std::move(search.layout);
  if (search.layout) {
    report_rivals(reading, *search.layout);
  } else if (search.unclosed_quote) {
    reading.diagnostics.add(kUnclosedQuote, "this quote is never closed; close it or remove it",
                            {reading.source, {*search.unclosed_quote, *search.unclosed_quote + 1}});
  } else {
    reading.diagnostics.add(kUnknownFormat,
                            "found no column of identifiers and addresses; give the columns with `--columns "
                            "name=...,address=...`, by their headers or numbers",
                            {reading.source, first});
  }
  return std::nullopt;
}

std::optional<SymbolTable> read_any_table(const Reading& reading) {
  auto layout = any_table_layout(reading);
  if (!layout) return std::nullopt;
  Columns& columns = layout->columns;
  if (!columns.has(Field::vendor_address)) {  // `Address`: of which vendor, its cells show
    columns.set(Field::vendor_address, columns[Field::iec_address]);
    columns.set(Field::iec_address, kNoColumn);
  }
  std::deque<std::string> arena;
  const std::vector<CsvRow> rows = sample_rows(reading.source->text(), *layout, arena);
  const std::vector<std::string_view> cells = sample_cells(rows, columns[Field::vendor_address]);
  const auto notation = address::likely_notation(cells);
  return read_table(
      reading, *layout,
      {.notation = notation.value_or(address::Notation::iec), .address_for_name = !columns.has(Field::name)});
}

}  // namespace

const ReaderInfo kAnyTable{"table", "table of symbols", any_table_likelihood, read_any_table};

}  // namespace symplant::read
