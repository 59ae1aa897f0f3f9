// The stations of a plant and those of its devices.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/panel/view.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::panel {

/// A station: a line and a process.
struct Station {
  std::string_view line;
  std::string_view process;

  /// As clients see it.
  std::string name() const {
    const std::string_view between = line.empty() || process.empty() ? "" : " ";
    return std::string(line).append(between).append(process);
  }
};

/// The stations of a plant and those of its devices.
struct Stations {
  std::vector<Station> stations;
  std::vector<std::uint32_t> of_unit;
  std::vector<std::string_view> labels;  ///< of units: the path within the station
};

/// Those of the view, or of the names of the devices. The result refers to both arguments. O(devices).
Stations stations_of(const trace::PlantNames& names, const View& view);

}  // namespace symplant::panel
