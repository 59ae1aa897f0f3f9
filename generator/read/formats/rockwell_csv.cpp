// Reads tag lists of Logix Designer in CSV.
#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "read/cells/csv.hpp"
#include "read/cells/lines.hpp"
#include "read/formats.hpp"
#include "read/rockwell/tags.hpp"
#include "read/rules/row_not_understood.hpp"
#include "read/rules/text_after_quote.hpp"
#include "read/rules/unclosed_quote.hpp"
#include "read/rules/unknown_format.hpp"
#include "read/unique_names.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kCsvHeaderBytes = 64 * 1024;
constexpr std::array<std::string_view, 2> kCsvHeaderBegins{"TYPE", "CONTROLLER"};  // the latter of several controllers

/// The header of a section. The separator of the list is the character after its first name.
struct CsvHeader {
  Line line;
  char delimiter;
};

/// `TYPE,SCOPE,NAME,`, maybe after a column `CONTROLLER`.
bool is_csv_header(std::string_view line, char delimiter) {
  const std::string controller = std::string(kCsvHeaderBegins[1]) + delimiter;
  if (text::equal_ignoring_case(line.substr(0, controller.size()), controller)) line.remove_prefix(controller.size());
  const std::string begin = {'T', 'Y', 'P', 'E', delimiter, 'S', 'C', 'O', 'P', 'E', delimiter, 'N', 'A', 'M', 'E'};
  return text::equal_ignoring_case(line.substr(0, begin.size()), begin) && line.size() > begin.size() &&
         line[begin.size()] == delimiter;
}

std::optional<CsvHeader> find_csv_header(std::string_view text) {
  LineReader lines(text.substr(0, kCsvHeaderBytes));
  Line line;
  while (lines.next(line)) {
    for (const std::string_view begin : kCsvHeaderBegins) {
      if (line.text.size() <= begin.size()) continue;
      const char delimiter = line.text[begin.size()];
      if (is_csv_header(line.text, delimiter)) return CsvHeader{line, delimiter};
    }
  }
  return std::nullopt;
}

class RockwellCsvReading {
 public:
  explicit RockwellCsvReading(const Reading& reading) : builder_(reading, address::Notation::rockwell) {}

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
    make_rows();
    return builder_.finish();
  }

 private:
  enum Column : std::uint8_t { type, scope, name, description, datatype, specifier, controller };
  static constexpr std::array<std::string_view, 7> kColumns{"TYPE",     "SCOPE",     "NAME",      "DESCRIPTION",
                                                            "DATATYPE", "SPECIFIER", "CONTROLLER"};

  /// Those of the row's controller; aliases lead to tags of the same one.
  RockwellTags& tags_of(const CsvRow& row) {
    const std::string_view of = cell(row, controller);
    const auto found = std::find_if(tags_.begin(), tags_.end(), [&](const auto& one) { return one.first == of; });
    if (found != tags_.end()) return found->second;
    return tags_.emplace_back(of, RockwellTags(builder_, RockwellTags::Texts::escaped)).second;
  }

  void make_rows() {
    if (tags_.size() == 1) return tags_.front().second.make_rows();
    for (auto& [of, tags] : tags_) tags.make_rows(of);
    if (tags_.empty()) return;
    builder_.decide("controllers: " + std::to_string(tags_.size()));
    qualify_repeated_names(builder_);
  }

  void take(const CsvRow& row) {
    const std::string_view kind = cell(row, type);
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
    if (is_header(row)) return take_header(row);
    if (row.blank() || text::equal_ignoring_case(kind, "remark")) return;
    report_row(row, "this row has an unknown type and is left out; types are TAG, ALIAS, COMMENT and RCOMMENT");
  }

  /// The columns may differ from those of the header before.
  static bool is_header(const CsvRow& row) {
    const std::size_t begin = text::equal_ignoring_case(row.cell(0), kColumns[controller]) ? 1 : 0;
    return text::equal_ignoring_case(row.cell(begin), kColumns[type]);
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
    tags_of(row).add(RockwellTag{cell(row, scope), cell(row, name), cell(row, datatype), target, cell(row, description),
                                 row.line, row.whole});
  }

  void add_comment(const CsvRow& row) {
    if (cell(row, specifier).empty()) {
      return report_row(row, "this comment has no operand and is left out; export the list again");
    }
    tags_of(row).add(
        RockwellComment{cell(row, scope), cell(row, specifier), cell(row, description), row.line, row.whole});
  }

  void report_row(const CsvRow& row, std::string message) {
    builder_.report(kRowNotUnderstood, std::move(message), row.whole);
  }

  TableBuilder builder_;
  std::deque<std::pair<std::string_view, RockwellTags>> tags_;                   ///< by controller
  std::array<std::size_t, kColumns.size()> index_{0, 1, 2, 3, 4, 5, kMaxCells};  ///< of each column in the rows
  std::size_t headers_ = 0;
  std::size_t rung_comments_ = 0;
};

int rockwell_csv_likelihood(std::string_view text) { return find_csv_header(text) ? 95 : 0; }

std::optional<SymbolTable> read_rockwell_csv(const Reading& reading) { return RockwellCsvReading(reading).read(); }

}  // namespace

const ReaderInfo kRockwellCsv{"rockwell-csv", "Logix Designer tags (CSV)", rockwell_csv_likelihood, read_rockwell_csv};

}  // namespace symplant::read
