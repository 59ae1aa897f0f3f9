// Where the panel shows the devices of a plant.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace symplant::panel {

inline constexpr std::int32_t kNotPlaced = -1;

struct DeviceView {
  std::uint32_t station = 0;    ///< index of a station
  std::int32_t x = kNotPlaced;  ///< in its station, in grid units from 0; kNotPlaced: the page chooses
  std::int32_t y = kNotPlaced;
};

/// The layout that names and the description give. Without one, stations follow from the devices' paths.
struct View {
  std::span<const DeviceView> devices = {};  ///< by unit; empty: none
  std::string_view stations = {};            ///< a station: its line, then its process, each ended by a NUL
};

}  // namespace symplant::panel
