// Reads the rows of a delimited list whose columns are known.
#include "read/cells/table_reading.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/large_memory.hpp"
#include "read/rules/cell_too_long.hpp"
#include "read/rules/header_alone.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/rules/text_after_quote.hpp"
#include "read/rules/unclosed_quote.hpp"
#include "read/table_builder.hpp"
#include "text/ascii.hpp"
#include "text/formula.hpp"

namespace symplant::read {

namespace {

/// Fields whose cells are bounded.
constexpr std::array kBounded{Field::klass,       Field::name, Field::vendor_address,
                              Field::iec_address, Field::type, Field::initial};

/// Whether a cell holds the word of a tool for "empty": `<No Value>`, in the language of the tool.
bool is_no_value(std::string_view cell, Field field) {
  if (cell.size() < 3 || cell.front() != '<' || cell.back() != '>') return false;
  if (field == Field::vendor_address || field == Field::iec_address || field == Field::initial) return true;
  return field == Field::comment && text::equal_ignoring_case(cell, "<No Value>");
}

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

class TableReading {
 public:
  TableReading(const Reading& reading, const Layout& layout, const TableKind& kind)
      : layout_(layout), kind_(kind), builder_(reading, kind.notation) {
    const std::size_t names = layout.columns[Field::name];
    if (names < layout.header.size()) header_name_ = layout.header[names];  // else by the cells, beyond the header
  }

  std::optional<SymbolTable> read() {
    SymbolTable& table = builder_.table();
    CsvReader reader(builder_.text(), layout_.delimiter, table.arena, layout_.rows_begin, layout_.rows_line);
    read_rows(reader);
    if (reader.unclosed_quote()) {
      const std::size_t quote = *reader.unclosed_quote();
      builder_.report(kUnclosedQuote, "this quote is never closed; close it or remove it", {quote, quote + 1});
      return std::nullopt;
    }
    if (too_long_) return std::nullopt;
    if (table.rows.empty()) {
      report_no_rows();
      return std::nullopt;
    }
    decide();
    return builder_.finish_bounded();  // each row was examined
  }

 private:
  void read_rows(CsvReader& reader) {
    base::reserve_large(builder_.table().rows, expected_rows());
    CsvRow row;
    while (reader.next(row)) {
      if (row.stray) {
        builder_.report(kTextAfterQuote,
                        "text follows the closing quote of a cell and is left out; "
                        "write a quote inside a quoted cell as `\"\"`",
                        *row.stray);
      }
      add(row);
    }
  }

  /// An estimate from the length of the first rows, plus a tenth: growing would cost more than unused room.
  std::size_t expected_rows() const {
    constexpr std::size_t kSample = 64 * 1024;
    const std::string_view rows = builder_.text().substr(layout_.rows_begin);
    const std::string_view sample = rows.substr(0, kSample);
    const auto lines = static_cast<std::size_t>(std::count(sample.begin(), sample.end(), '\n')) + 1;
    const std::size_t length = std::max<std::size_t>(sample.size() / lines, 16);
    return rows.size() <= kSample ? lines : rows.size() / length * 11 / 10;
  }

  std::string_view cell(const CsvRow& row, Field field) const {
    const std::string_view text = row.cell(layout_.columns[field]);
    if (is_no_value(text, field)) return {};
    return kind_.is_protected ? text::unprotected(text) : text;
  }

  void add(const CsvRow& row) {
    if (kind_.is_remark != nullptr && kind_.is_remark(row)) return;
    std::string_view name = cell(row, Field::name);
    if (name.empty() && kind_.address_for_name) {
      name = cell(row, Field::vendor_address);
      if (name.empty()) name = cell(row, Field::iec_address);
      named_by_address_ += name.empty() ? 0U : 1U;
    }
    if (name.empty()) return leave_out(row);
    if (row.whole.end - row.whole.begin > kLongestCell && has_cell_too_long(row)) return;
    if (is_header_again(row)) return builder_.begin_part();
    ListRow& made = builder_.table().rows.emplace_back(ListRow{
        cell(row, Field::klass), name, cell(row, Field::vendor_address), cell(row, Field::iec_address),
        cell(row, Field::type), cell(row, Field::initial), cell(row, Field::comment), row.line, kNoExtra, row.whole});
    if (kind_.sort_addresses) sort_addresses(made);
    const std::string_view scope = cell(row, Field::scope);
    if (!scope.empty()) builder_.extra(made).scope = scope;
  }

  void leave_out(const CsvRow& row) {
    if (row.blank()) return;
    ++left_out_;
    builder_.report(kRowWithoutIdentifier,
                    "this row has no identifier and is left out; give it one in column " +
                        std::to_string(layout_.columns[Field::name] + 1),
                    row.whole);
  }

  /// Whether a cell that is read is too long; reports the first.
  bool has_cell_too_long(const CsvRow& row) {
    for (const Field field : kBounded) {
      const std::string_view text = cell(row, field);
      if (text.size() <= kLongestCell) continue;
      const text::Span location = builder_.source().span_of(text, row.whole);
      builder_.report(kCellTooLong,
                      "this cell has " + std::to_string(text.size()) + " bytes, but at most " +
                          std::to_string(kLongestCell) + " are allowed; add the missing line end or quote",
                      {location.begin, location.begin + 1});
      too_long_ = true;
      return true;
    }
    return false;
  }

  /// Whether the row repeats the header, as in a text joined from several exports.
  bool is_header_again(const CsvRow& row) const {
    if (header_name_.empty() || cell(row, Field::name) != header_name_) return false;
    for (const Field field : {Field::vendor_address, Field::iec_address, Field::type}) {
      const std::string_view text = cell(row, field);
      if (looks_like_iec_address(text) || looks_like_vendor_address(text) || text == "BOOL") return false;
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

  void decide() {
    const std::string columns = describe(layout_.columns, layout_.header);
    builder_.table().summary = summary_of(layout_.columns, layout_.header);
    builder_.decide("delimiter: " + std::string(delimiter_name(layout_.delimiter)));
    builder_.decide(layout_.header_line ? "header: line " + std::to_string(*layout_.header_line)
                                        : "no header: columns recognized by their content, from line " +
                                              std::to_string(layout_.rows_line) + " on");
    builder_.decide("columns: " + columns);
    if (exchanged_ != 0) {
      builder_.decide("addresses in the other address column: " + std::to_string(exchanged_) +
                      "; their notation decides");
    }
    if (named_by_address_ != 0) {
      builder_.decide("rows without a name: " + std::to_string(named_by_address_) + "; their address is their name");
    }
    builder_.decide("rows: " + std::to_string(builder_.table().rows.size()) + " read, " + std::to_string(left_out_) +
                    " left out");
  }

  void report_no_rows() {
    const std::size_t at = layout_.rows_begin == 0 ? 0 : layout_.rows_begin - 1;
    builder_.report(kHeaderAlone,
                    layout_.header_line ? "the list has a header, but no row with a symbol; export the list again"
                                        : "the list has no row with a symbol; export the list again",
                    builder_.source().span_of(builder_.source().line_at(at)));
  }

  const Layout& layout_;
  const TableKind& kind_;
  TableBuilder builder_;
  std::string header_name_;
  std::size_t left_out_ = 0;
  std::size_t exchanged_ = 0;
  std::size_t named_by_address_ = 0;
  bool too_long_ = false;  // a cell was too long
};

}  // namespace

std::optional<SymbolTable> read_table(const Reading& reading, const Layout& layout, const TableKind& kind) {
  return TableReading(reading, layout, kind).read();
}

std::vector<std::string_view> sample_cells(const std::vector<CsvRow>& rows, std::size_t column) {
  std::vector<std::string_view> cells;
  for (const CsvRow& row : rows) {
    if (!row.cell(column).empty()) cells.push_back(row.cell(column));
  }
  return cells;
}

}  // namespace symplant::read
