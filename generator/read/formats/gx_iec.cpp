// Reads global variable lists of GX IEC Developer 7.
#include "read/gx_iec.hpp"

#include <algorithm>
#include <utility>

#include "base/large_memory.hpp"
#include "read/cells/csv.hpp"
#include "read/formats.hpp"
#include "read/gx_columns.hpp"
#include "read/rules/cell_too_long.hpp"
#include "read/rules/header_alone.hpp"
#include "read/rules/missing_column.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/rules/text_after_quote.hpp"
#include "read/rules/unclosed_quote.hpp"
#include "read/rules/unknown_format.hpp"

namespace symplant::read {

namespace {

std::string_view delimiter_name(char delimiter) {
  switch (delimiter) {
    case '\t':
      return "TAB";
    case ';':
      return "`;`";
    default:
      return "`,`";
  }
}

class GxIecReading {
 public:
  GxIecReading(std::shared_ptr<const text::SourceFile> source, diag::Diagnostics& diagnostics)
      : source_(std::move(source)), diagnostics_(diagnostics) {}

  std::optional<SymbolTable> read() {
    const GxSearch search = find_gx_layout(source_->text());
    if (!search.layout) {
      report_no_list(search);
      return std::nullopt;
    }
    const GxLayout& layout = *search.layout;
    table_.source = source_;
    CsvReader reader(source_->text(), layout.delimiter, table_.arena, layout.rows_begin, layout.rows_line);
    read_rows(reader, layout);
    if (reader.unclosed_quote()) {
      report_unclosed(*reader.unclosed_quote());
      return std::nullopt;
    }
    if (too_long_) return std::nullopt;
    if (table_.rows.empty()) {
      report_no_rows(layout);
      return std::nullopt;
    }
    decide(layout);
    return std::move(table_);
  }

 private:
  void read_rows(CsvReader& reader, const GxLayout& layout) {
    base::reserve_large(table_.rows, expected_rows(layout));
    CsvRow row;
    while (reader.next(row)) {
      if (row.stray) {
        diagnostics_.add(kTextAfterQuote,
                         "text follows the closing quote of a cell and is left out; "
                         "write a quote inside a quoted cell as `\"\"`",
                         {source_, *row.stray});
      }
      add(row, layout);
    }
  }

  /// An estimate from the length of the first rows, plus a tenth: growing would cost more than unused room.
  std::size_t expected_rows(const GxLayout& layout) const {
    constexpr std::size_t kSample = 64 * 1024;
    const std::string_view rows = source_->text().substr(layout.rows_begin);
    const std::string_view sample = rows.substr(0, kSample);
    const auto lines = static_cast<std::size_t>(std::count(sample.begin(), sample.end(), '\n')) + 1;
    const std::size_t length = std::max<std::size_t>(sample.size() / lines, 16);
    return rows.size() <= kSample ? lines : rows.size() / length * 11 / 10;
  }

  void add(const CsvRow& row, const GxLayout& layout) {
    const auto cell = [&](GxField field) { return row.cell(layout.columns[field]); };
    const std::string_view name = cell(GxField::name);
    if (name.empty()) {
      if (row.blank()) return;
      ++left_out_;
      diagnostics_.add(kRowWithoutIdentifier,
                       "this row has no identifier and is left out; give it one in column " +
                           std::to_string(layout.columns[GxField::name] + 1),
                       {source_, row.whole});
      return;
    }
    if (row.whole.end - row.whole.begin > kLongestCell && has_cell_too_long(row, layout)) return;
    if (layout.header_line && name == layout.header_name && is_header_again(row, layout)) return;
    ListRow& made = table_.rows.emplace_back(
        ListRow{cell(GxField::klass), name, cell(GxField::vendor_address), cell(GxField::iec_address),
                cell(GxField::type), cell(GxField::initial), cell(GxField::comment), row.line, kNoExtra, row.whole});
    sort_addresses(made);
  }

  /// Whether a cell that is read is too long; reports the first.
  bool has_cell_too_long(const CsvRow& row, const GxLayout& layout) {
    for (const GxField field : {GxField::klass, GxField::name, GxField::vendor_address, GxField::iec_address,
                                GxField::type, GxField::initial}) {
      const std::string_view cell = row.cell(layout.columns[field]);
      if (cell.size() <= kLongestCell) continue;
      const text::Span location = source_->span_of(cell, row.whole);
      diagnostics_.add(kCellTooLong,
                       "this cell has " + std::to_string(cell.size()) + " bytes, but at most " +
                           std::to_string(kLongestCell) + " are allowed; add the missing line end or quote",
                       {source_, {location.begin, location.begin + 1}});
      too_long_ = true;
      return true;
    }
    return false;
  }

  /// Whether the row repeats the header, as in a list joined from several exports.
  static bool is_header_again(const CsvRow& row, const GxLayout& layout) {
    for (const GxField field : {GxField::vendor_address, GxField::iec_address, GxField::type}) {
      const std::string_view cell = row.cell(layout.columns[field]);
      if (looks_like_iec_address(cell) || looks_like_vendor_address(cell) || cell == "BOOL") return false;
    }
    return true;
  }

  void sort_addresses(ListRow& row) {
    const bool iec_as_vendor = looks_like_iec_address(row.vendor_address) && !looks_like_iec_address(row.iec_address);
    const bool vendor_as_iec = row.vendor_address.empty() && looks_like_vendor_address(row.iec_address);
    if (!iec_as_vendor && !vendor_as_iec) return;
    std::swap(row.vendor_address, row.iec_address);
    ++exchanged_;
  }

  void decide(const GxLayout& layout) {
    auto& decisions = table_.decisions;
    decisions.push_back("delimiter: " + std::string(delimiter_name(layout.delimiter)));
    decisions.push_back(layout.header_line ? "header: line " + std::to_string(*layout.header_line)
                                           : "no header: columns recognized by their content, from line " +
                                                 std::to_string(layout.rows_line) + " on");
    decisions.push_back("columns: " + describe(layout.columns));
    if (exchanged_ != 0) {
      decisions.push_back("addresses in the other address column: " + std::to_string(exchanged_) +
                          "; their notation decides");
    }
    decisions.push_back("rows: " + std::to_string(table_.rows.size()) + " read, " + std::to_string(left_out_) +
                        " left out");
  }

  void report_unclosed(std::size_t offset) {
    diagnostics_.add(kUnclosedQuote, "this quote is never closed; close it or remove it",
                     {source_, {offset, offset + 1}});
  }

  void report_no_rows(const GxLayout& layout) {
    diagnostics_.add(kHeaderAlone,
                     layout.header_line ? "the list has a header, but no row with a symbol; export the list again"
                                        : "the list has no row with a symbol; export the list again",
                     {source_, source_->span_of(source_->line_at(layout.rows_begin == 0 ? 0 : layout.rows_begin - 1))});
  }

  void report_no_list(const GxSearch& search) {
    if (search.unclosed_quote) return report_unclosed(*search.unclosed_quote);
    if (search.nameless_header) {
      diagnostics_.add(kMissingColumn,
                       "this header has no column of identifiers; name a column `Identifier`, `Label Name`, "
                       "`Variable` or `Name`",
                       {source_, *search.nameless_header});
      return;
    }
    diagnostics_.add(kUnknownFormat,
                     "found neither a header with a column of identifiers nor a class such as `VAR_GLOBAL`, so this is "
                     "not a list of global variables; export one, or put a header above the rows",
                     {source_, source_->span_of(source_->line_at(0))});
  }

  std::shared_ptr<const text::SourceFile> source_;
  diag::Diagnostics& diagnostics_;
  SymbolTable table_;
  std::size_t left_out_ = 0;
  std::size_t exchanged_ = 0;
  bool too_long_ = false;  // a cell was too long
};

}  // namespace

int gx_iec_likelihood(std::string_view text) {
  const GxSearch search = find_gx_layout(text);
  if (!search.layout) return search.nameless_header || search.unclosed_quote ? 10 : 0;
  if (!search.layout->header_line) return 50;
  const GxColumns& columns = search.layout->columns;
  return columns.has(GxField::vendor_address) && columns.has(GxField::iec_address) ? 90 : 60;
}

std::optional<SymbolTable> read_gx_iec(const Reading& reading) {
  return GxIecReading(reading.source, reading.diagnostics).read();
}

const ReaderInfo kGxIec{"gx-iec", "GX IEC Developer 7 global variable list", gx_iec_likelihood, read_gx_iec};

}  // namespace symplant::read
