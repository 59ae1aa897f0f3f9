// Writes links and rows to fill in as CSV.
#include "app/infer_links.hpp"

#include <utility>

#include "convert/link_row.hpp"

namespace symplant::app {

std::string infer_links_text(const std::vector<name::NamedLink>& links, const std::vector<infer::OpenLink>& open) {
  std::string text(convert::kLinksHeader);
  for (const name::NamedLink& link : links) text += convert::link_row(link);
  if (open.empty()) return text;
  text +=
      "# Rows to fill in: names do not say which event reports that an operation has reached its state.\n"
      "# Remove the # of a row and write the event. For a second event of a state, add a row without operation.\n";
  for (const infer::OpenLink& link : open) {
    std::string events;
    for (const std::string& event : link.events) events.append(events.empty() ? "" : " | ").append(event);
    std::string line = "# ";
    line.append(link.text).append(link.text.empty() ? "" : "; ").append("close to it: ").append(events);
    text.append(convert::on_one_line(std::move(line))).push_back('\n');
    std::string row = convert::link_row({link.operation, "", link.state});
    row.pop_back();
    text.append("#").append(convert::on_one_line(std::move(row))).push_back('\n');
  }
  return text;
}

}  // namespace symplant::app
