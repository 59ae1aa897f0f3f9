// The node ids of a link `opc-ua-server`; without open62541, for `symplant map`.
#include "symplant/link/opc_ua/carried.hpp"
#include "symplant/link/opc_ua/server_link.hpp"
#include "symplant/link/opc_ua/server_nodes.hpp"
#include "symplant/link/opc_ua/server_settings.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::opc_ua {

std::string server_fault(std::string_view rest) {
  const auto settings = read_server_settings(rest);
  const auto* const error = std::get_if<LinkError>(&settings);
  return error == nullptr ? std::string() : error->message;
}

std::variant<LinkMap, LinkError> server_map(std::string_view /*rest*/, const LinkChoice& link,
                                            const tables::PlantTables& tables) {
  Carried carried = carried_symbols(tables, link.controller, link.settings);
  const auto texts = tables::split_names(tables.symbol_names);
  LinkMap map;
  map.where = "node id";
  map.left_out = std::move(carried.left_out);
  map.symbols.reserve(carried.map.points.size());
  for (const image::Point& point : carried.map.points) {
    map.symbols.push_back(
        {point.symbol, symbol_node_text(texts[std::size_t{point.symbol} * 2]), WordOrder::low_first, point.on_loss});
  }
  return map;
}

}  // namespace symplant::link::opc_ua
