// The rows of a table of another tool.
#include "recording/table_rows.hpp"

namespace symplant::recording {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// A cell without quotes around, if it has no others.
std::string_view unquoted(std::string_view cell) {
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return cell;
  const std::string_view inside = cell.substr(1, cell.size() - 2);
  return inside.find('"') == inside.npos ? inside : cell;
}

}  // namespace

TableRows::TableRows(std::string_view text, char delimiter)
    : text_(text), delimiter_(delimiter), csv_(text, delimiter, arena_, 0, 1, kMostColumns) {}

bool TableRows::next() {
  arena_.clear();
  if (!csv_.next(row_)) return false;
  if (row_.stray) split_unquoted();
  return true;
}

bool TableRows::is_cut_in_quote() const {
  const auto quote = csv_.unclosed_quote();
  return quote && text_.find_first_of("\r\n", *quote) == text_.npos;
}

void TableRows::split_unquoted() {
  const std::string_view whole = text_.substr(row_.whole.begin, row_.whole.end - row_.whole.begin);
  row_.cells.clear();
  for (std::size_t begin = 0; row_.cells.size() < kMostColumns;) {
    const std::size_t end = whole.find(delimiter_, begin);
    row_.cells.push_back(unquoted(trimmed(whole.substr(begin, end - begin))));
    if (end == whole.npos) break;
    begin = end + 1;
  }
}

}  // namespace symplant::recording
