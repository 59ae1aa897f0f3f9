// What drives each event.
#include "symplant/panel/picture/drivers.hpp"

namespace symplant::panel {

std::vector<std::string_view> drivers_of(const tables::PlantTables& tables) {
  std::vector<std::string_view> drivers(tables.symbols.size(), "none");
  for (std::size_t s = 0; s < drivers.size(); ++s) {
    const tables::SymbolRow& row = tables.symbols[s];
    if (row.direction() == tables::Direction::event && row.moved()) drivers[s] = "device";
  }
  for (const tables::SensorRow& sensor : tables.material.sensors) drivers[sensor.symbol] = "parts";
  for (const tables::FollowRow& follow : tables.follows) drivers[follow.symbol] = "follow";
  for (const tables::SignalRow& signal : tables.values.signals) drivers[signal.symbol] = "signal";
  for (const tables::SharedAddress& shared : tables.shared_addresses) {
    if (drivers[shared.symbol] == "none") drivers[shared.symbol] = drivers[shared.leader];
  }
  return drivers;
}

}  // namespace symplant::panel
