// Cells of fixed width, and quoted cells whose quotes are not escaped.
#include "read/cells/padded.hpp"

#include "text/utf8.hpp"

namespace symplant::read {

namespace {

constexpr std::string_view kBetweenQuotedCells = "\",\"";
constexpr char32_t kFirstWideCharacter = 0x2E80;

}  // namespace

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

std::string squeezed(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c != ' ' || result.empty() || result.back() != ' ') result += c;
  }
  return result;
}

std::string_view cut_columns(std::string_view& text, std::size_t columns) {
  std::size_t at = 0;
  std::size_t used = 0;
  while (at < text.size() && used < columns) {
    const text::CodePoint point = text::code_point_at(text, at);
    at += point.length;
    used += point.value >= kFirstWideCharacter && point.valid ? 2 : 1;
  }
  const std::string_view cut = text.substr(0, at);
  text.remove_prefix(at);
  return without_blanks(cut);
}

bool split_quoted(std::string_view line, std::size_t before, std::size_t after, std::vector<std::string_view>& cells) {
  cells.assign(before + 1 + after, {});
  line = without_blanks(line);
  if (line.size() < 2 || line.front() != '"' || line.back() != '"') return false;
  line = line.substr(1, line.size() - 2);
  for (std::size_t i = 0; i < before; ++i) {
    const std::size_t end = line.find(kBetweenQuotedCells);
    if (end == std::string_view::npos) return false;
    cells[i] = line.substr(0, end);
    line.remove_prefix(end + kBetweenQuotedCells.size());
  }
  for (std::size_t i = cells.size() - 1; i > before; --i) {
    const std::size_t end = line.rfind(kBetweenQuotedCells);
    if (end == std::string_view::npos) return false;
    cells[i] = line.substr(end + kBetweenQuotedCells.size());
    line = line.substr(0, end);
  }
  cells[before] = line;
  return true;
}

}  // namespace symplant::read
