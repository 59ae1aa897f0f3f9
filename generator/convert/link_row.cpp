// Writes links as CSV.
#include "convert/link_row.hpp"

#include <algorithm>

#include "convert/cells.hpp"

namespace symplant::convert {
namespace {

/// A line that begins with `#` would be a comment.
void append_first_cell(std::string& row, std::string_view text) {
  if (!text.starts_with('#')) return append_cell(row, text);
  std::string cell;
  append_cell(cell, text);
  row += cell.starts_with('"') ? cell : '"' + cell + '"';
}

}  // namespace

std::string link_row(const name::NamedLink& link) {
  std::string row;
  append_first_cell(row, link.operation);
  append_cell(row += ',', link.event);
  append_cell(row += ',', link.state);
  return row + '\n';
}

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace symplant::convert
