// What is wrong with the maps of a plant's links.
#include "app/map_findings.hpp"

#include <algorithm>
#include <string>

#include "base/ascii.hpp"
#include "check/rules.hpp"
#include "lower/lower.hpp"
#include "model/description_rules.hpp"
#include "symplant/link/io_map.hpp"

namespace symplant::app {
namespace {

using Kind = link::MapFault::Kind;

/// "/links/0": the link whose settings a controller has.
model::Pointer link_pointer(const model::PlantModel& plant, std::uint32_t controller) {
  const auto& links = plant.description->links;
  const auto is_its = [&](const model::LinkDescription& link) {
    return link.has_settings &&
           (link.controller.empty() ? plant.controllers.size() == 1 || plant.controllers[controller].empty()
                                    : base::equal_ignoring_case(link.controller, plant.controllers[controller]));
  };
  const auto found = std::find_if(links.begin(), links.end(), is_its);
  return model::Pointer("/links") / static_cast<std::size_t>(found - links.begin());
}

/// The key that is to be changed.
model::Pointer key_of(Kind kind, const model::Pointer& link) {
  switch (kind) {
    case Kind::beyond_size:
      return link / "size";
    case Kind::status_overlap:
    case Kind::status_beyond:
      return link / "status";
    case Kind::watchdog_overlap:
    case Kind::watchdog_beyond:
      return link / "watchdog";
    case Kind::overlap:
    case Kind::beyond_end:
      break;
  }
  return link / "map";
}

}  // namespace

bool places_can_meet(const model::PlantModel& plant) {
  const bool is_set = std::any_of(plant.description->links.begin(), plant.description->links.end(),
                                  [](const model::LinkDescription& link) { return link.has_settings; });
  return is_set || std::any_of(plant.symbols.begin(), plant.symbols.end(),
                               [](const model::Symbol& symbol) { return link::places_of(symbol.type) > 1; });
}

void add_map_findings(const model::PlantModel& plant, diag::Diagnostics& diagnostics) {
  const lower::EngineTables lowered = lower::lower(plant);
  const core::PlantTables tables = lowered.tables();
  std::vector<model::DescriptionFault> faults;
  for (std::uint32_t controller = 0; controller < plant.links.size(); ++controller) {
    const link::IoMap map = link::make_io_map(tables, controller, plant.links[controller].settings());
    for (const link::MapFault& fault : map.faults) {
      std::string message = link::fault_text(tables, map, fault);
      if (fault.kind != Kind::overlap) {
        faults.push_back({key_of(fault.kind, link_pointer(plant, controller)).text(), std::move(message), 0,
                          model::FaultKind::contradiction});
        continue;
      }
      const model::Symbol& other = plant.symbols[fault.symbol];
      const model::Symbol& symbol = plant.symbols[fault.other];
      diagnostics.add(check::kPlacesOverlap.info, check::about(symbol), std::move(message),
                      check::place_of(plant, *symbol.row, symbol.address_cell),
                      {{check::place_of(plant, *other.row, other.address_cell), "the other symbol"}});
    }
  }
  if (!faults.empty()) model::add_findings(plant.description_source, faults, diagnostics);
}

}  // namespace symplant::app
