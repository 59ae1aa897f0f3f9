// The images of the link `opc-ua-server`: the symbols that it carries, and the status of the plant.
#pragma once

#include "symplant/link/image/map.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/opc_ua/carried.hpp"
#include "symplant/link/status_fields.hpp"

namespace symplant::link::opc_ua {

/// With room for the status after the numbers of all events, by which the server knows the cycle of an image.
/// O(symbols).
inline image::Map server_image(const tables::PlantTables& tables, const LinkChoice& link) {
  image::Map map = carried_symbols(tables, link.controller, link.settings).map;
  std::uint32_t& numbers = map.sizes[static_cast<std::size_t>(Plane::event_numbers)];
  map.status = numbers;
  numbers += static_cast<std::uint32_t>(kStatusFields.size());
  return map;
}

}  // namespace symplant::link::opc_ua
