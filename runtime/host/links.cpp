// The links of a run.
#include "symplant/host/links.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "symplant/host/exit_codes.hpp"
#include "symplant/link/io_map.hpp"

namespace symplant::host {

bool keeps_plants_links_closed(const RunOptions& options) {
  using Clock = RunOptions::Clock;
  return options.clock == Clock::virtual_time || (!options.scenario.empty() && options.clock == Clock::automatic);
}

std::vector<std::string> link_urls(const PlantProgram& program, const RunOptions& options) {
  if (!options.links.empty() || keeps_plants_links_closed(options)) return options.links;
  std::vector<std::string> urls;
  for (const DefaultLink& link : program.links) urls.emplace_back(link.url);
  if (urls.empty() && !program.default_link.empty()) urls.emplace_back(program.default_link);
  return urls;
}

bool has_real_link(const std::vector<std::string>& urls) {
  return std::any_of(urls.begin(), urls.end(), [](const std::string& url) { return url != "loop:"; });
}

std::vector<bool> carried_operations(const std::vector<std::string>& urls, const core::PlantTables& tables) {
  std::vector<bool> carried(tables.symbols.size());
  if (!has_real_link(urls)) return carried;
  for (const link::IoPoint& point : link::make_io_map(tables).points) {
    carried[point.symbol] = tables.symbols[point.symbol].direction() == core::Direction::operation;
  }
  return carried;
}

int open_links(const std::vector<std::string>& urls, const core::PlantTables& tables, const core::Plant& plant,
               Links& links, std::ostream& err) {
  for (const std::string& url : urls) {
    auto opened = link::open_link(url, tables, &plant);
    if (const auto* error = std::get_if<link::LinkError>(&opened)) {
      err << "error: " << error->message << "\n";
      return error->kind == link::LinkError::Kind::usage ? kBadInput : kEnvironment;
    }
    links.push_back(std::get<std::unique_ptr<link::Link>>(std::move(opened)));
  }
  return kGood;
}

}  // namespace symplant::host
