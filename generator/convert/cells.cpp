// Cells of delimited text.
#include "convert/cells.hpp"

#include "text/formula.hpp"

namespace symplant::convert {
namespace {

bool needs_quotes(std::string_view text) {
  if (text.empty()) return false;
  return text.find_first_of(",;\t\"\r\n") != text.npos || text.front() == ' ' || text.back() == ' ';
}

}  // namespace

void append_cell(std::string& row, std::string_view text) {
  if (!needs_quotes(text)) {
    row += text;
    return;
  }
  row += '"';
  for (const char c : text) {
    row += c;
    if (c == '"') row += c;
  }
  row += '"';
}

void append_protected_cell(std::string& row, std::string_view text) {
  if (!text::needs_protection(text)) return append_cell(row, text);
  append_cell(row, "'" + std::string(text));
}

}  // namespace symplant::convert
