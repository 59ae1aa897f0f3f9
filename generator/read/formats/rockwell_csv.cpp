// Reads tag lists of Logix Designer in CSV.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "read/cells/csv.hpp"
#include "read/cells/lines.hpp"
#include "read/formats.hpp"
#include "read/rockwell/tags.hpp"
#include "read/rules/row_not_understood.hpp"
#include "read/rules/text_after_quote.hpp"
#include "read/rules/unclosed_quote.hpp"
#include "read/rules/unknown_format.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kCsvHeaderBytes = 64 * 1024;
constexpr std::string_view kCsvHeaderBegin = "TYPE";

/// The header of a section. The separator of the list is the character after its first name.
struct CsvHeader {
  Line line;
  char delimiter;
};

bool is_csv_header(std::string_view line, char delimiter) {
  const std::string begin = {'T', 'Y', 'P', 'E', delimiter, 'S', 'C', 'O', 'P', 'E', delimiter, 'N', 'A', 'M', 'E'};
  return text::equal_ignoring_case(line.substr(0, begin.size()), begin) && line.size() > begin.size() &&
         line[begin.size()] == delimiter;
}

std::optional<CsvHeader> find_csv_header(std::string_view text) {
  LineReader lines(text.substr(0, kCsvHeaderBytes));
  Line line;
  while (lines.next(line)) {
    if (line.text.size() <= kCsvHeaderBegin.size()) continue;
    const char delimiter = line.text[kCsvHeaderBegin.size()];
    if (is_csv_header(line.text, delimiter)) return CsvHeader{line, delimiter};
  }
  return std::nullopt;
}

class RockwellCsvReading {
 public:
  explicit RockwellCsvReading(const Reading& reading)
      : builder_(reading, address::Notation::rockwell), tags_(builder_, RockwellTags::Texts::escaped) {}

  std::optional<SymbolTable> read() {
    const auto header = find_csv_header(builder_.text());
    if (!header) {
      builder_.report(kUnknownFormat, "found no header `TYPE,SCOPE,NAME,...`; export the tags as CSV again",
                      builder_.source().span_of(builder_.source().line_at(0)));
      return std::nullopt;
    }
    CsvReader rows(builder_.text(), header->delimiter, builder_.table().arena, header->line.begin, header->line.number);
    CsvRow row;
    while (rows.next(row)) take(row);
    if (rows.unclosed_quote()) {
      const std::size_t quote = *rows.unclosed_quote();
      builder_.report(kUnclosedQuote, "this quote is never closed; close it or remove it", {quote, quote + 1});
      return std::nullopt;
    }
    builder_.decide("headers: " + std::to_string(headers_) + ", the first in line " +
                    std::to_string(header->line.number));
    if (rung_comments_ != 0) builder_.decide("comments on rungs: " + std::to_string(rung_comments_) + ", left out");
    tags_.make_rows();
    return builder_.finish();
  }

 private:
  enum Column : std::uint8_t { type, scope, name, description, datatype, specifier };
  static constexpr std::array<std::string_view, 6> kColumns{"TYPE",        "SCOPE",    "NAME",
                                                            "DESCRIPTION", "DATATYPE", "SPECIFIER"};

  void take(const CsvRow& row) {
    const std::string_view kind = row.cell(0);
    if (row.stray) {
      builder_.report(kTextAfterQuote,
                      "text follows the closing quote of a cell and is left out; write a quote in a text as `$Q`",
                      *row.stray);
    }
    if (kind == "COMMENT") return add_comment(row);
    if (kind == "TAG" || kind == "ALIAS") return add_tag(row, kind == "ALIAS");
    if (kind == "RCOMMENT") {
      ++rung_comments_;
      return;
    }
    if (text::equal_ignoring_case(kind, kColumns[type])) return take_header(row);
    if (row.blank() || text::equal_ignoring_case(kind, "remark")) return;
    report_row(row, "this row has an unknown type and is left out; types are TAG, ALIAS, COMMENT and RCOMMENT");
  }

  void take_header(const CsvRow& row) {
    ++headers_;
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      const auto is_named = [&](std::string_view cell) { return text::equal_ignoring_case(cell, kColumns[i]); };
      const auto found = std::find_if(row.cells.begin(), row.cells.end(), is_named);
      index_[i] = found == row.cells.end() ? kMaxCells : static_cast<std::size_t>(found - row.cells.begin());
    }
  }

  std::string_view cell(const CsvRow& row, Column column) const { return row.cell(index_[column]); }

  void add_tag(const CsvRow& row, bool is_alias) {
    const std::string_view target = is_alias ? cell(row, specifier) : std::string_view();
    if (cell(row, name).empty() || (is_alias && target.empty())) {
      return report_row(row, is_alias ? "this alias has no name or no target and is left out; export the list again"
                                      : "this tag has no name and is left out; export the list again");
    }
    tags_.add(RockwellTag{cell(row, scope), cell(row, name), cell(row, datatype), target, cell(row, description),
                          row.line, row.whole});
  }

  void add_comment(const CsvRow& row) {
    if (cell(row, specifier).empty()) {
      return report_row(row, "this comment has no operand and is left out; export the list again");
    }
    tags_.add(RockwellComment{cell(row, scope), cell(row, specifier), cell(row, description), row.line, row.whole});
  }

  void report_row(const CsvRow& row, std::string message) {
    builder_.report(kRowNotUnderstood, std::move(message), row.whole);
  }

  TableBuilder builder_;
  RockwellTags tags_;
  std::array<std::size_t, kColumns.size()> index_{0, 1, 2, 3, 4, 5};  ///< of each column in the rows
  std::size_t headers_ = 0;
  std::size_t rung_comments_ = 0;
};

int rockwell_csv_likelihood(std::string_view text) { return find_csv_header(text) ? 95 : 0; }

std::optional<SymbolTable> read_rockwell_csv(const Reading& reading) { return RockwellCsvReading(reading).read(); }

}  // namespace

const ReaderInfo kRockwellCsv{"rockwell-csv", "Logix Designer tags (CSV)", rockwell_csv_likelihood, read_rockwell_csv};

}  // namespace symplant::read
