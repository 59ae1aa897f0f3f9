// Writes links and rows to fill in as CSV.
#include "app/infer_links.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "convert/cells.hpp"

namespace symplant::app {
namespace {

/// A line that begins with `#` would be a comment.
void append_first_cell(std::string& row, std::string_view text) {
  if (!text.starts_with('#')) return convert::append_cell(row, text);
  std::string cell;
  convert::append_cell(cell, text);
  row += cell.starts_with('"') ? cell : '"' + cell + '"';
}

std::string row_text(const name::NamedLink& link) {
  std::string row;
  append_first_cell(row, link.operation);
  convert::append_cell(row += ',', link.event);
  convert::append_cell(row += ',', link.state);
  return row + '\n';
}

/// For a comment: a name with a line end would end it.
std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

std::string infer_links_text(const std::vector<name::NamedLink>& links, const std::vector<infer::OpenLink>& open) {
  std::string text = "operation,event,state\n";
  for (const name::NamedLink& link : links) text += row_text(link);
  if (open.empty()) return text;
  text +=
      "# Rows to fill in: names do not say which event reports that an operation has reached its state.\n"
      "# Remove the # of a row and write the event. For a second event of a state, add a row without operation.\n";
  for (const infer::OpenLink& link : open) {
    std::string events;
    for (const std::string& event : link.events) events.append(events.empty() ? "" : " | ").append(event);
    std::string line = "# ";
    line.append(link.text).append(link.text.empty() ? "" : "; ").append("close to it: ").append(events);
    text.append(on_one_line(std::move(line))).push_back('\n');
    std::string row = row_text({link.operation, "", link.state});
    row.pop_back();
    text.append("#").append(on_one_line(std::move(row))).push_back('\n');
  }
  return text;
}

}  // namespace symplant::app
