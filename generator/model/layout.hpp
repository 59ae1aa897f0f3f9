// Where the panel shows the devices of a plant.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// A frame with devices: a line and a process, or a group that the description names.
struct Station {
  std::string line;
  std::string process;

  bool operator==(const Station&) const = default;
};

struct DevicePlace {
  std::uint32_t station = 0;
  std::int32_t x = -1;  ///< in grid units; -1: the page chooses
  std::int32_t y = -1;
};

struct Layout {
  std::vector<Station> stations;     ///< in the order of their first device
  std::vector<DevicePlace> devices;  ///< by unit
};

/// Whether the layout does not follow from the paths of devices alone: under a custom naming rule, or with a `view`.
bool has_layout(const PlantModel& plant);

/// O(units * log(stations) + entries of `view`).
Layout layout_of(const PlantModel& plant);

/// Reports devices of `view` that the plant does not have. O(units) if there are any entries.
void check_view(const PlantModel& plant, description::Faults& faults);

}  // namespace symplant::model
