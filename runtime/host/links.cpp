// The links of a run.
#include "symplant/host/links.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "symplant/host/exit_codes.hpp"
#include "symplant/host/words.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/name_index.hpp"

namespace symplant::host {

std::string OpenLink::silence() const {
  using trace::seconds;
  const link::LinkSettings& settings = choice.settings;
  if (settings.watchdog != link::kNowhere) {
    return "its watchdog, holding register " + std::to_string(settings.watchdog) + ", has not changed for " +
           seconds(settings.watchdog_within) + "; check whether the PLC's program runs";
  }
  if (link->status().is_client) {
    return "the PLC has not answered for " + seconds(settings.loss_after) +
           "; check whether it is switched on and connected";
  }
  if (link->status().has_nodes) {
    return "for " + seconds(settings.loss_after) +
           " no client has read or written a symbol, or been connected with a subscription; check whether the PLC runs "
           "and is connected";
  }
  return "no valid request for a mapped address has arrived for " + seconds(settings.loss_after) +
         "; check whether the PLC runs and is connected";
}

std::string OpenLink::absence() const {
  if (link->status().is_client) {
    return "the PLC has answered no request; check whether it is switched on and connected, and the URL";
  }
  if (link->status().has_nodes) {
    return "no client has read or written a symbol, or had a subscription; check whether the PLC runs, and whether it "
           "uses this address and these node ids";
  }
  return "no valid request for a mapped address has arrived; check whether the PLC runs, and whether it uses this "
         "address "
         "and these numbers";
}

std::vector<trace::PlantNames::Link> named_links(const Links& links) {
  std::vector<trace::PlantNames::Link> named;
  for (const OpenLink& open : links) {
    const bool freezes = open.choice.settings.plant_on_loss == link::PlantOnLoss::freeze;
    named.push_back({open.text(), open.silence(), open.absence(), open.choice.controller, freezes});
  }
  return named;
}

bool keeps_plants_links_closed(const RunOptions& options, bool with_program) {
  using enum RunOptions::Clock;
  return options.clock == virtual_time || ((!options.scenario.empty() || with_program) && options.clock == automatic);
}

std::variant<LinkChoices, link::LinkError> links_of(const PlantProgram& program, const RunOptions& options,
                                                    const std::vector<bool>& with_program) {
  const bool any_program = std::find(with_program.begin(), with_program.end(), true) != with_program.end();
  std::vector<link::LinkRequest> requests;
  for (const std::string& text : options.links) requests.push_back(link::parse_request(text));
  if (requests.empty() && !keeps_plants_links_closed(options, any_program)) {
    for (const DefaultLink& own : program.links) {
      requests.push_back({std::string(own.controller), std::string(own.url)});
    }
    if (requests.empty() && !program.default_link.empty())
      requests.push_back(link::parse_request(program.default_link));
  }
  auto chosen = link::choose_links(program.tables, requests);
  if (auto* choices = std::get_if<LinkChoices>(&chosen)) {
    if (options.links.empty()) {
      std::erase_if(*choices, [&](const link::LinkChoice& choice) {
        return choice.controller < with_program.size() && with_program[choice.controller];
      });
    }
    for (link::LinkChoice& choice : *choices) {
      if (choice.controller < program.link_settings.size()) choice.settings = program.link_settings[choice.controller];
      choice.settings.on_loss = options.on_loss.value_or(choice.settings.on_loss);
      choice.settings.arm = options.arm;
    }
  }
  return chosen;
}

bool has_real_link(const LinkChoices& links) {
  return std::any_of(links.begin(), links.end(), [](const link::LinkChoice& l) { return !link::is_loop(l.url); });
}

bool goes_to_plc(const LinkChoices& links) {
  return std::any_of(links.begin(), links.end(), [](const link::LinkChoice& l) { return link::is_client(l.url); });
}

std::string left_out_words(const link::LinkChoice& choice, const tables::PlantTables& tables) {
  constexpr std::size_t kMostOf = 10;
  if (link::is_loop(choice.url)) return "";
  const auto made = link::map_of(choice, tables);
  const auto* const map = std::get_if<link::LinkMap>(&made);  // an error is reported when the link is opened
  if (map == nullptr) return "";
  const std::size_t all = map->symbols.size() + map->left_out.size();
  if (map->left_out.empty() || kMostOf * map->left_out.size() < all) return "";
  const link::Unreachable& first = map->left_out.front();
  return fmt::format(
      "carries {} of {}: `{}` {}{}; `symplant map` lists all symbols", map->symbols.size(), plural(all, "I/O symbol"),
      shown(trace::NameIndex(tables.symbol_names)[2 * std::size_t{first.symbol}]), first.reason,
      map->left_out.size() == 1 ? "" : fmt::format(", and {} more are left out", map->left_out.size() - 1));
}

std::vector<bool> carried_symbols(const LinkChoices& links, const tables::PlantTables& tables) {
  std::vector<bool> carried(tables.symbols.size());
  for (const link::LinkChoice& choice : links) {
    if (link::is_loop(choice.url)) continue;
    const auto map = link::map_of(choice, tables);
    const auto* const good = std::get_if<link::LinkMap>(&map);
    if (good == nullptr) continue;
    for (const link::MappedSymbol& mapped : good->symbols) carried[mapped.symbol] = true;
  }
  return carried;
}

int open_links(const LinkChoices& chosen, const tables::PlantTables& tables, const plant::Plant& plant, Links& links,
               std::ostream& err) {
  const auto controllers = tables::split_names(tables.controller_names);
  for (const link::LinkChoice& choice : chosen) {
    auto opened = link::open_link(choice, tables, &plant);
    if (const auto* error = std::get_if<link::LinkError>(&opened)) {
      err << "error: " << error->message << "\n";
      return error->kind == link::LinkError::Kind::usage ? kBadInput : kEnvironment;
    }
    const bool says_whose = controllers.size() > 1 && choice.controller < controllers.size();
    links.push_back({says_whose ? std::string(controllers[choice.controller]) : std::string(), choice,
                     std::get<std::unique_ptr<link::Link>>(std::move(opened))});
  }
  return kGood;
}

}  // namespace symplant::host
