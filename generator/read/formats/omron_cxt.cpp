// Reads the symbols of CX-Programmer projects in text form (.cxt).
#include <array>
#include <optional>
#include <string>

#include "read/cells/lines.hpp"
#include "read/cells/padded.hpp"
#include "read/formats.hpp"
#include "read/rules/row_not_understood.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/rules/unclosed_quote.hpp"
#include "read/table_builder.hpp"
#include "read/unique_names.hpp"
#include "text/ascii.hpp"

namespace symplant::read {

namespace {

constexpr std::string_view kCxtFirstKey = "CXProgVer:=";
constexpr std::string_view kCxtListKey = "VariableList:=";
constexpr std::string_view kCxtListBegin = "BEGIN_LIST_$#[";
constexpr std::string_view kCxtListEnd = "END_LIST_$#[";
constexpr std::string_view kCxtBlockMark = "$?St$Bk?_#[";
constexpr std::string_view kCxtConstant = "VAR_GLOBAL_CONSTANT";
constexpr std::size_t kCxtSearchedBytes = 64 * 1024;

/// name, address, type, type of a function block, `A` for an automatic address; then the comment.
constexpr std::size_t kCxtCellsBeforeComment = 5;
using CxtCells = std::array<std::string_view, kCxtCellsBeforeComment>;

/// Cuts a cell and the comma after it from `rest`. A cell in quotes may have commas. False if there is no comma.
bool cut_cxt_cell(std::string_view& rest, std::string_view& cell) {
  const bool quoted = rest.starts_with('"');
  const std::size_t end = quoted ? rest.find("\",", 1) : rest.find(',');
  if (end == std::string_view::npos) return false;
  cell = without_blanks(quoted ? rest.substr(1, end - 1) : rest.substr(0, end));
  rest.remove_prefix(end + (quoted ? 2 : 1));
  return true;
}

class CxtReading {
 public:
  explicit CxtReading(const Reading& reading) : builder_(reading, address::Notation::omron), lines_(builder_.text()) {}

  std::optional<SymbolTable> read() {
    Line line;
    while (!failed_ && lines_.next(line)) take(without_blanks(line.text));
    if (failed_) return std::nullopt;
    builder_.decide("symbols: " + std::to_string(global_) + " global, " + std::to_string(local_) + " of programs, " +
                    std::to_string(nameless_) + " of them without a name, which are named by their addresses");
    if (local_ != 0) qualify_repeated_names(builder_);
    return builder_.finish();
  }

 private:
  /// A line outside the lists of symbols. The name of a program is the first after `Program[N]:=`.
  void take(std::string_view line) {
    if (line.starts_with("Program[")) program_.reset();
    if (line == "Programs:=") in_programs_ = true;
    if (line.starts_with("Name:=") && in_programs_ && !program_) program_ = name_in(line.substr(6));
    if (line != kCxtListKey) return;
    Line next;
    if (lines_.next(next) && without_blanks(next.text).starts_with(kCxtListBegin)) read_list();
  }

  static std::string_view name_in(std::string_view value) {
    if (value.ends_with(';')) value.remove_suffix(1);
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
    return value;
  }

  void read_list() {
    const std::string_view scope = in_programs_ ? program_.value_or(std::string_view()) : std::string_view();
    Line line;
    while (!failed_ && lines_.next(line)) {
      const std::string_view text = without_blanks(line.text);
      if (text.starts_with(kCxtListEnd)) return;
      if (!text.empty()) read_row(line, text, scope);
    }
  }

  void read_row(const Line& line, std::string_view rest, std::string_view scope) {
    CxtCells cells;
    for (std::string_view& cell : cells) {
      if (!cut_cxt_cell(rest, cell)) return report_row(line);
    }
    if (rest.empty()) {
      const auto comment = read_block();
      return comment ? add(line, cells, *comment, scope) : report_row(line);
    }
    if (!rest.ends_with(';')) return report_row(line);
    rest.remove_suffix(1);
    if (rest.size() >= 2 && rest.front() == '"' && rest.back() == '"') rest = rest.substr(1, rest.size() - 2);
    add(line, cells, without_blanks(rest), scope);
  }

  /// The comment of a row that goes on in a block between two equal marks; nothing if no block follows.
  std::optional<std::string_view> read_block() {
    const LineReader before = lines_;
    Line mark;
    if (!lines_.next(mark) || !mark.text.starts_with(kCxtBlockMark)) {
      lines_ = before;
      return std::nullopt;
    }
    const std::string_view text = builder_.text();
    const std::size_t begin = lines_.offset();
    const std::size_t end = text.find(mark.text, begin);
    if (end == std::string_view::npos) {
      builder_.report(kUnclosedQuote, "the comment that begins here is never closed; export the project again",
                      mark.span());
      failed_ = true;
      return std::nullopt;
    }
    Line last;
    while (lines_.offset() <= end && lines_.next(last)) {
    }
    std::string_view comment = without_blanks(text.substr(begin, end - begin));
    while (comment.ends_with('\n') || comment.ends_with('\r')) comment.remove_suffix(1);
    return comment;
  }

  void add(const Line& line, const CxtCells& cells, std::string_view comment, std::string_view scope) {
    const auto& [name, address, type, block_type, automatic] = cells;
    if (name.empty() && address.empty()) {
      builder_.report(kRowWithoutIdentifier, "this row has no name and no address and is left out; name the symbol",
                      line.span());
      return;
    }
    ++(in_programs_ ? local_ : global_);
    if (name.empty()) ++nameless_;
    ListRow& row = builder_.add({line.begin, lines_end()}, line.number);
    row.name = name.empty() ? address : name;
    row.type = type;
    row.comment = comment;
    if (text::equal_ignoring_case(type, "NUMBER")) {
      row.klass = kCxtConstant;
      row.initial = address;
    } else if (automatic.empty()) {
      row.vendor_address = address;
    }
    if (!scope.empty()) builder_.extra(row).scope = scope;
  }

  /// The end of the row that was read last, without its line end.
  std::size_t lines_end() const {
    const std::string_view text = builder_.text();
    std::size_t end = lines_.offset();
    while (end > 0 && (text[end - 1] == '\n' || text[end - 1] == '\r')) --end;
    return end;
  }

  void report_row(const Line& line) {
    if (failed_) return;
    builder_.report(kRowNotUnderstood,
                    "this row does not have the form `name,address,type,,,comment;` and is left out; export the "
                    "project again",
                    line.span());
  }

  TableBuilder builder_;
  LineReader lines_;
  std::optional<std::string_view> program_;  ///< the program whose lists follow
  bool in_programs_ = false;
  bool failed_ = false;
  std::size_t global_ = 0;
  std::size_t local_ = 0;
  std::size_t nameless_ = 0;
};

int omron_cxt_likelihood(std::string_view text) {
  text = text.substr(0, kCxtSearchedBytes);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return 0;
  if (text.substr(begin).starts_with(kCxtFirstKey)) return 95;
  return text.find(kCxtListKey) != std::string_view::npos && text.find(kCxtListBegin) != std::string_view::npos ? 90
                                                                                                                : 0;
}

std::optional<SymbolTable> read_omron_cxt(const Reading& reading) { return CxtReading(reading).read(); }

}  // namespace

const ReaderInfo kOmronCxt{"omron-cxt", "CX-Programmer project as text (.cxt)", omron_cxt_likelihood, read_omron_cxt};

}  // namespace symplant::read
