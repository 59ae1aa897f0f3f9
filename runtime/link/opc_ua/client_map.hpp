// The nodes of a PLC's server that a link `opc-ua` reads and writes.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "symplant/link/image/map.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/link/opc_ua/client_settings.hpp"
#include "symplant/link/opc_ua/node_id.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::opc_ua {

/// A node, and the position of its value in the images.
struct ClientNode {
  NodeId id;
  Plane plane = Plane::operation_bits;
  std::uint32_t position = 0;
  tables::DataType type = tables::DataType::boolean;
  std::string symbol;  ///< name of the first symbol at the position, for messages
};

struct ClientMap {
  image::Map image;                    ///< without a status
  std::vector<ClientNode> operations;  ///< one of each position that a point has
  std::vector<ClientNode> events;
  std::vector<std::string> addresses;  ///< node ids of the points of `image`, in their order
  std::vector<Unreachable> left_out;
};

/// The nodes of a controller's symbols: by `node` of the symbol's settings, otherwise by `nodes` of the URL. Symbols of
/// one address have one node, that of the first of them with a `node`. Errors, of kind usage: no template at all for
/// any symbol, an invalid node id, and a node of an event that another symbol also has. O(symbols log symbols).
std::variant<ClientMap, LinkError> make_client_map(const tables::PlantTables& tables, std::uint32_t controller,
                                                   const LinkSettings& link, const ClientSettings& settings);

}  // namespace symplant::link::opc_ua
