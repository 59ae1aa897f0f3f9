// The description of a plant for the panel's clients: what does not change during a run.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/panel/role.hpp"
#include "symplant/panel/view.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

/// A link of the run, for its clients.
struct LinkName {
  std::string url;
  std::string controller;
  std::uint32_t carries;  ///< index of the controller whose symbols it carries, or link::kAllControllers
};

/// Appends the keys of `GET /api/v1/plant` that follow from the tables: stations, devices, symbols, material,
/// requirements, links, and for a trainer malfunctions. O(plant).
void put_plant(std::string& json, const trace::PlantNames& names, const View& view, const std::vector<LinkName>& links,
               Role role);

}  // namespace symplant::panel
