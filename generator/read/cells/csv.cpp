// Reads the rows of a delimited text, as views into it.
#include "read/cells/csv.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "base/words.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kSniffedBytes = 64 * 1024;
constexpr std::size_t kSniffedRows = 100;
constexpr std::array kDelimiters{'\t', ';', ','};

/// How often each delimiter occurs outside quotes in a row.
using Counts = std::array<std::size_t, kDelimiters.size()>;

std::vector<Counts> count_delimiters(std::string_view text) {
  std::vector<Counts> rows;
  Counts counts{};
  bool quoted = false;
  bool any = false;
  const auto end_row = [&] {
    if (any) rows.push_back(counts);
    counts = {};
    any = false;
  };
  for (const char c : text.substr(0, kSniffedBytes)) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '\n' || c == '\r')) {
      end_row();
      if (rows.size() == kSniffedRows) return rows;
      continue;
    }
    any = true;
    if (quoted) continue;
    for (std::size_t i = 0; i < kDelimiters.size(); ++i) counts[i] += c == kDelimiters[i] ? 1U : 0U;
  }
  end_row();
  return rows;
}

}  // namespace

char sniff_delimiter(std::string_view text) {
  const std::vector<Counts> rows = count_delimiters(text);
  char best = ',';
  std::pair<std::size_t, std::size_t> best_score{0, 0};
  for (std::size_t i = 0; i < kDelimiters.size(); ++i) {
    std::map<std::size_t, std::size_t> rows_by_count;
    for (const Counts& counts : rows) {
      if (counts[i] != 0) ++rows_by_count[counts[i]];
    }
    // Most equal rows, then most columns: prose has commas, but not the same number in every row.
    for (const auto& [count, alike] : rows_by_count) {
      const std::pair score{alike, count};
      if (score <= best_score) continue;
      best_score = score;
      best = kDelimiters[i];
    }
  }
  return best;
}

bool CsvRow::blank() const {
  return std::all_of(cells.begin(), cells.end(), [](std::string_view cell) { return cell.empty(); });
}

inline void CsvReader::skip_blanks() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
}

inline std::string_view CsvReader::plain_cell() {
  const std::size_t begin = at_;
  at_ = ends_.next(begin);
  std::size_t end = at_;
  while (end > begin && is_blank(text_[end - 1])) --end;
  return {text_.data() + begin, end - begin};
}

bool CsvReader::next(CsvRow& row) {
  if (at_ >= text_.size() || unclosed_quote_) return false;
  row.cells.clear();
  row.line = line_;
  row.whole = {at_, at_};
  row.stray.reset();
  for (;;) {
    skip_blanks();
    std::string_view cell;
    if (at_ < text_.size() && text_[at_] == '"') {
      if (!quoted_cell(row, cell)) return false;
    } else {
      cell = plain_cell();
    }
    if (row.cells.size() < most_cells_) row.cells.push_back(cell);
    if (at_ >= text_.size() || text_[at_] != delimiter_) break;
    ++at_;
  }
  row.whole.end = at_;
  end_row();
  return true;
}

bool CsvReader::quoted_cell(CsvRow& row, std::string_view& cell) {
  const std::size_t open = at_;
  bool doubled = false;
  std::size_t close = open + 1;
  for (;; ++close) {
    close = base::find_any(text_, close, '"', '\n', '\r');
    if (close >= text_.size()) {
      unclosed_quote_ = open;
      return false;
    }
    const bool paired = close + 1 < text_.size();
    if (text_[close] == '\n' || (text_[close] == '\r' && !(paired && text_[close + 1] == '\n'))) {
      ++line_;
    } else if (text_[close] == '"') {
      if (!paired || text_[close + 1] != '"') break;
      doubled = true;
      ++close;
    }
  }
  cell = text_.substr(open + 1, close - open - 1);
  if (doubled) {
    std::string& copy = arena_.emplace_back();
    copy.reserve(cell.size());
    for (std::size_t i = 0; i < cell.size(); ++i) {
      copy += cell[i];
      if (cell[i] == '"') ++i;
    }
    cell = copy;
  }
  while (!cell.empty() && (cell.front() == ' ' || cell.front() == '\t')) cell.remove_prefix(1);
  while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t')) cell.remove_suffix(1);
  at_ = close + 1;
  skip_blanks();
  const std::string_view stray = plain_cell();
  if (!stray.empty() && !row.stray) {
    const auto begin = static_cast<std::size_t>(stray.data() - text_.data());
    row.stray = text::Span{begin, begin + stray.size()};
  }
  return true;
}

void CsvReader::end_row() {
  if (at_ >= text_.size()) return;
  at_ += text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n' ? 2U : 1U;
  ++line_;
}

}  // namespace symplant::read
