// The custom behavior classes as views.
#include "emit/behaviour_view.hpp"

#include "emit/type_view.hpp"
#include "text/identifier.hpp"

namespace symplant::emit {

std::vector<View> behaviour_views(const lower::EngineTables& tables, const model::PlantModel& plant,
                                  const std::vector<std::string>& classes) {
  std::vector<View> views;
  std::vector<std::vector<std::uint32_t>> devices;
  for (const tables::BehaviourUnit& row : tables.behaviour_units) {
    if (row.name == views.size()) {  // names are numbered in the order of their first device
      View& view = views.emplace_back();
      const std::string name = text::identifier(plant.units[row.unit].described->behaviour);
      view.texts["behaviour"] = name;
      view.texts["base"] = classes[tables.units[row.unit].type];
      view.texts["behaviour_file"] = name + "_behavior.hpp";
      devices.emplace_back();
    }
    devices[row.name].push_back(row.unit);
  }
  for (std::size_t i = 0; i < views.size(); ++i) views[i].lists["devices"] = device_lines(devices[i], plant);
  return views;
}

}  // namespace symplant::emit
