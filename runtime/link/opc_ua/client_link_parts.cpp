// The link `opc-ua`.
#include "symplant/link/opc_ua/client_link_parts.hpp"

#include <memory>
#include <utility>

#include "symplant/link/opc_ua/client_dialog.hpp"
#include "symplant/link/opc_ua/client_map.hpp"
#include "symplant/link/opc_ua/client_security.hpp"
#include "symplant/link/opc_ua/client_settings.hpp"

namespace symplant::link::opc_ua {

client::PartsResult client_link_parts(std::string_view rest, const LinkChoice& link,
                                      const tables::PlantTables& tables) {
  auto read = read_client_settings(rest);
  if (auto* error = std::get_if<LinkError>(&read)) return std::move(*error);
  const auto& settings = std::get<ClientSettings>(read);
  auto made = make_client_map(tables, link.controller, link.settings, settings);
  if (auto* error = std::get_if<LinkError>(&made)) return std::move(*error);
  ClientMap& map = std::get<ClientMap>(made);
  auto security = ClientSecurity::load(settings.security);
  if (auto* error = std::get_if<LinkError>(&security)) return std::move(*error);
  client::ClientParts parts{.dialog = nullptr,
                            .map = map.image,
                            .addresses = map.addresses,
                            .word_orders = {},
                            .unreachable = map.left_out,
                            .times = settings.times,
                            .notes = client::request_notes(map.operations.empty() ? 0 : 1, map.events.empty() ? 0 : 1,
                                                           map.events.empty() ? 0 : 1)};
  parts.word_orders.resize(parts.map.points.size(), WordOrder::low_first);
  parts.dialog = std::make_unique<ClientDialog>(settings, std::get<ClientSecurity>(std::move(security)), std::move(map),
                                                link.settings.reads_only);
  return parts;
}

}  // namespace symplant::link::opc_ua
