// The stations of a plant and those of its devices.
#include "symplant/panel/picture/stations.hpp"

#include <cctype>
#include <map>

#include "symplant/tables/names.hpp"

namespace symplant::panel {
namespace {

/// `LINE_PROC_DEV` or `LINE_PROC_DEV.FACET`, divided at its separators.
Stations stations_by_path(const trace::PlantNames& names) {
  Stations found;
  std::map<std::string_view, std::uint32_t> known;
  for (std::uint32_t unit = 0; unit < names.tables().units.size(); ++unit) {
    const std::string_view path = names.unit(unit);
    const std::size_t line_end = path.find('_');
    const std::size_t station_end = line_end == path.npos ? path.npos : path.find('_', line_end + 1);
    const std::string_view station = station_end == path.npos ? std::string_view() : path.substr(0, station_end);
    const auto [place, added] = known.try_emplace(station, static_cast<std::uint32_t>(found.stations.size()));
    if (added) {
      found.stations.push_back(station.empty() ? Station{}
                                               : Station{station.substr(0, line_end), station.substr(line_end + 1)});
    }
    found.of_unit.push_back(place->second);
    found.labels.push_back(station.empty() ? path : path.substr(station_end + 1));
  }
  return found;
}

/// The path of a device without the names of its station, each followed by a separator; the path if it is in a group.
std::string_view within(const Station& station, std::string_view path) {
  std::string_view rest = path;
  for (const std::string_view level : {station.line, station.process}) {
    if (level.empty()) continue;
    if (!rest.starts_with(level) || rest.size() < level.size() + 2) return path;
    if (std::isalnum(static_cast<unsigned char>(rest[level.size()])) != 0) return path;
    rest.remove_prefix(level.size() + 1);
  }
  return rest;
}

}  // namespace

Stations stations_of(const trace::PlantNames& names, const View& view) {
  if (view.devices.empty()) return stations_by_path(names);
  Stations found;
  const std::vector<std::string_view> texts = tables::split_names(view.stations);
  for (std::size_t i = 0; i + 1 < texts.size(); i += 2) found.stations.push_back({texts[i], texts[i + 1]});
  for (std::uint32_t unit = 0; unit < names.tables().units.size(); ++unit) {
    const std::uint32_t station = view.devices[unit].station;
    found.of_unit.push_back(station);
    found.labels.push_back(within(found.stations[station], names.unit(unit)));
  }
  return found;
}

}  // namespace symplant::panel
