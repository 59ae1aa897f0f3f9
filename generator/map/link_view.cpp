// One link of a plant with everything that the formats of `symplant map` show.
#include "map/link_view.hpp"

#include <algorithm>
#include <utility>

#include "map/findings.hpp"
#include "symplant/link/choice.hpp"
#include "symplant/link/kinds.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::map {

namespace {

using Choices = std::vector<link::LinkChoice>;

link::LinkError usage_error(std::string message) { return {link::LinkError::Kind::usage, std::move(message)}; }

/// As in plant.json, one for each controller.
Choices own_links(const LinkedPlant& of) {
  Choices choices;
  const std::size_t controllers = std::max<std::size_t>(1, tables::split_names(of.tables.controller_names).size());
  for (std::uint32_t controller = 0; controller < controllers; ++controller) {
    const description::LinkDescription* const own = link_of(of.plant, controller);
    choices.push_back({own == nullptr ? "" : own->url, controller});
  }
  return choices;
}

std::variant<Choices, link::LinkError> chosen_links(const LinkedPlant& of, const std::vector<std::string>& links) {
  std::vector<link::LinkRequest> requests;
  requests.reserve(links.size());
  for (const std::string& text : links) requests.push_back(link::parse_request(text));
  for (const link::LinkRequest& request : requests) {
    if (std::string fault = link::url_fault(request.url); !fault.empty()) return usage_error(std::move(fault));
    if (link::kind_of(request.url)->map == nullptr) {
      return usage_error("`" + request.url + "` carries symbols by name, it has no map of addresses");
    }
  }
  return link::choose_links(of.tables, requests);
}

/// An error if the URL does not fit the plant.
std::variant<LinkView, link::LinkError> view_of(std::shared_ptr<const LinkedPlant> of, link::LinkChoice choice) {
  LinkView view;
  choice.settings = of->plant.links[choice.controller].settings();
  auto made = link::map_of(choice, of->tables);
  if (auto* error = std::get_if<link::LinkError>(&made)) return std::move(*error);
  view.map = std::get<link::LinkMap>(std::move(made));
  view.mapped.resize(of->tables.symbols.size());
  for (const link::MappedSymbol& mapped : view.map.symbols) view.mapped[mapped.symbol] = &mapped;
  if (view.is_server()) {
    view.points.resize(view.mapped.size());
    for (const link::modbus::IoPoint& point : view.served().points) view.points[point.symbol] = &point;
  }
  view.choice = std::move(choice);
  view.of = std::move(of);
  return view;
}

}  // namespace

std::variant<std::vector<LinkView>, link::LinkError> views_of(const std::shared_ptr<const LinkedPlant>& of,
                                                              const std::vector<std::string>& links) {
  auto choices = links.empty() ? std::variant<Choices, link::LinkError>(own_links(*of)) : chosen_links(*of, links);
  if (auto* error = std::get_if<link::LinkError>(&choices)) return std::move(*error);
  std::vector<LinkView> views;
  for (link::LinkChoice& choice : std::get<Choices>(choices)) {
    auto view = view_of(of, std::move(choice));
    if (auto* error = std::get_if<link::LinkError>(&view)) return std::move(*error);
    views.push_back(std::get<LinkView>(std::move(view)));
  }
  return views;
}

std::string on_loss_text(const tables::PlantTables& tables, const link::MappedSymbol& mapped) {
  if (mapped.on_loss == link::OnLoss::hold) return "holds";
  return tables.symbols[mapped.symbol].inverted() ? "on" : "off";
}

}  // namespace symplant::map
