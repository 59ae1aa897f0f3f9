// Which link of a plant a command reads, without writing to its PLC.
#include "app/read_link.hpp"

#include <fmt/format.h>

#include <utility>

#include "symplant/link/client_parts.hpp"

namespace symplant::app {

using link::LinkError;

namespace {

LinkError wrong_link(std::string message) { return {LinkError::Kind::usage, std::move(message)}; }

}  // namespace

std::variant<link::LinkChoice, LinkError> link_to_read(std::string_view command, const std::vector<std::string>& links,
                                                       const model::PlantModel& plant,
                                                       const tables::PlantTables& tables) {
  std::vector<link::LinkRequest> requests;
  requests.reserve(links.size());
  for (const std::string& text : links) requests.push_back(link::parse_request(text));
  if (requests.empty()) {
    for (const description::LinkDescription& link : plant.description->links) {
      requests.push_back({link.controller, link.url});
    }
  }
  if (requests.empty()) return wrong_link("the plant has no link: give `--link URL`");
  if (requests.size() > 1) {
    return wrong_link(fmt::format(
        "there are {} links, and one call reads one PLC: give one `--link PLC1=URL`, and run one `{}` for each PLC",
        requests.size(), command));
  }
  if (const std::string& url = requests.front().url; !link::is_client(url)) {
    const std::string fault = link::url_fault(url);
    return wrong_link(fault.empty() ? fmt::format("`{}` is not a link to a PLC that can be read: give `--link "
                                                  "modbus-tcp://HOST:PORT` or `--link slmp://HOST:PORT?family=...`",
                                                  url)
                                    : fault);
  }
  auto chosen = link::choose_links(tables, requests);
  if (auto* error = std::get_if<LinkError>(&chosen)) return std::move(*error);
  link::LinkChoice choice = std::get<std::vector<link::LinkChoice>>(std::move(chosen)).front();
  if (choice.controller < plant.links.size()) choice.settings = plant.links[choice.controller].settings();
  choice.settings.reads_only = true;
  return choice;
}

}  // namespace symplant::app
