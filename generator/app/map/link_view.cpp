// One link of a plant with everything that the formats of `symplant map` show.
#include "app/map/link_view.hpp"

#include <utility>

#include "app/map/texts.hpp"
#include "symplant/link/client_parts.hpp"

namespace symplant::app {

std::string LinkView::location(const link::IoPoint& point) const {
  if (!client) return address_text(point);
  return client->addresses[static_cast<std::size_t>(&point - map.points.data())];
}

std::variant<LinkView, link::LinkError> view_of(std::shared_ptr<const LinkedPlant> of, link::LinkChoice choice) {
  LinkView view;
  choice.settings = of->plant.links[choice.controller].settings();
  if (link::is_client(choice.url)) {
    auto made = link::client_parts(choice, of->tables);
    if (auto* error = std::get_if<link::LinkError>(&made)) return std::move(*error);
    view.client = std::move(std::get<link::client::ClientParts>(made));
    view.map = std::move(view.client->map);
  } else {
    view.map = link::make_io_map(of->tables, choice.controller, choice.settings);
  }
  view.points.resize(of->tables.symbols.size());
  for (const link::IoPoint& point : view.map.points) view.points[point.symbol] = &point;
  view.choice = std::move(choice);
  view.of = std::move(of);
  return view;
}

bool is_written(link::Table table) { return table == link::Table::coil || table == link::Table::holding_register; }

std::string on_loss_text(const tables::PlantTables& tables, const link::IoPoint& point) {
  if (point.on_loss == link::OnLoss::hold) return "holds";
  return tables.symbols[point.symbol].inverted() ? "on" : "off";
}

}  // namespace symplant::app
