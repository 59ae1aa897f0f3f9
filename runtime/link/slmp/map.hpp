// Where each symbol lies in a PLC's memory, and in the images of its link.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/image/map.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/slmp/plan.hpp"
#include "symplant/link/slmp/settings.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::slmp {

/// A cell of numbers and the lane of the image that has its word.
struct NumberCell {
  Cell cell;
  std::uint32_t lane = 0;
};

/// The cells of one direction, both in ascending order without duplicates. Lane i of the plane of bits is bits[i].
struct Cells {
  std::vector<Cell> bits;
  std::vector<NumberCell> numbers;
};

struct DeviceMap {
  image::Map image;
  Cells operations;
  Cells events;
  std::vector<Device> devices;         ///< of the points of `image`, in their order
  std::vector<WordOrder> word_orders;  ///< of these points
  std::vector<Unreachable> unreachable;
};

/// The map of a controller's symbols. A symbol's device is its address, unless `settings` move it. Errors, of kind
/// usage: no choice for events at X, an event at Y, one location for two symbols of different addresses or directions,
/// numbers of X and Y that the list has in another base than the family. O(symbols log symbols).
std::variant<DeviceMap, LinkError> make_device_map(const tables::PlantTables& tables, std::uint32_t controller,
                                                   const LinkSettings& link, const Settings& settings);

}  // namespace symplant::link::slmp
