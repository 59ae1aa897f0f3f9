// Where the panel shows the devices of a plant.
#include "model/layout.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "symplant/tables/nearest.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

/// The line and process of a unit, as its first symbol has them.
Station station_of(const PlantModel& plant, const Unit& unit) {
  const std::uint32_t first = unit.first_symbol();
  const SymbolReading& reading = plant.symbols[first].reading;
  return {std::string(reading.line()), std::string(reading.process())};
}

}  // namespace

bool has_layout(const PlantModel& plant) { return plant.pairing != nullptr || !plant.description->view.empty(); }

Layout layout_of(const PlantModel& plant) {
  text::ByName<const description::GivenView*> given;
  for (const description::GivenView& view : plant.description->view) given[view.device] = &view;
  Layout layout;
  std::map<std::pair<std::string, std::string>, std::uint32_t> known;
  for (const Unit& unit : plant.units) {
    Station station = station_of(plant, unit);
    DevicePlace place;
    if (const auto found = given.find(unit.device_path()); found != given.end()) {
      place.x = found->second->x;
      place.y = found->second->y;
      if (!found->second->group.empty()) station = {"", found->second->group};
    }
    const auto next = static_cast<std::uint32_t>(layout.stations.size());
    const auto [at, added] = known.try_emplace({station.line, station.process}, next);
    if (added) layout.stations.push_back(std::move(station));
    place.station = at->second;
    layout.devices.push_back(place);
  }
  return layout;
}

void check_view(const PlantModel& plant, description::Faults& faults) {
  for (const description::GivenView& view : plant.description->view) {
    tables::NearestName nearest(view.device);
    bool found = false;
    for (const Unit& unit : plant.units) {
      found = found || text::equal_ignoring_case(unit.device_path(), view.device);
      nearest.offer(unit.device_path());
    }
    if (found) continue;
    faults.add(description::Pointer("/view") / std::string_view(view.device),
               description::missing("device " + description::ticked(view.device), nearest.name()),
               description::FaultKind::unknown_name);
  }
}

}  // namespace symplant::model
