// Where each symbol lies in a PLC's memory, and in the images of its link.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/io_map.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/slmp/plan.hpp"
#include "symplant/link/slmp/settings.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::slmp {

/// The cells of one direction. Lane i of the table of bits is bit_cells[i], register i is number_cells[i]; both ascend
/// without duplicates.
struct Cells {
  std::vector<Cell> bits;
  std::vector<Cell> numbers;
};

struct DeviceMap {
  IoMap io;  ///< numbers are positions in the images, not devices
  Cells operations;
  Cells events;
  std::vector<Device> devices;  ///< of the points of `io`, in their order
  std::vector<client::Unreachable> unreachable;
};

/// The map of a controller's symbols. A symbol's device is its address, as `settings` move it. Errors, of kind usage:
/// no choice for events at X, an event at Y, one location for two symbols of different addresses or directions, X and Y
/// that the list counts otherwise than the family. O(symbols log symbols).
std::variant<DeviceMap, LinkError> make_device_map(const tables::PlantTables& tables, std::uint32_t controller,
                                                   const LinkSettings& link, const Settings& settings);

}  // namespace symplant::link::slmp
