// The link `modbus-tcp`.
#include "symplant/link/modbus/client_link_parts.hpp"

#include <memory>
#include <utility>

#include "symplant/link/modbus/client_dialog.hpp"
#include "symplant/link/modbus/client_map.hpp"
#include "symplant/link/modbus/client_settings.hpp"

namespace symplant::link::modbus {

std::string client_fault(std::string_view rest) {
  const auto settings = read_client_settings(rest);
  const auto* const error = std::get_if<LinkError>(&settings);
  return error == nullptr ? std::string() : error->message;
}

client::PartsResult client_link_parts(std::string_view rest, const LinkChoice& link,
                                      const tables::PlantTables& tables) {
  auto read = read_client_settings(rest, link.settings.reads_only);
  if (auto* error = std::get_if<LinkError>(&read)) return std::move(*error);
  const auto& settings = std::get<ClientSettings>(read);
  auto made = make_client_map(tables, link.controller, link.settings, settings);
  if (auto* error = std::get_if<LinkError>(&made)) return std::move(*error);
  const IoMap& map = std::get<IoMap>(made);
  if (!map.faults.empty()) {
    return LinkError{LinkError::Kind::usage, fault_text(tables, map, map.faults.front())};
  }
  image::Map placed = image_of(tables, map);
  auto dialog = std::make_unique<ModbusDialog>(settings, map, placed);
  client::ClientParts parts{.dialog = nullptr,
                            .map = std::move(placed),
                            .addresses = client_addresses(map, settings),
                            .word_orders = {},
                            .unreachable = unreachable_symbols(map),
                            .times = settings.times,
                            .notes = dialog->notes()};
  for (const IoPoint& point : map.points) parts.word_orders.push_back(point.word_order);
  parts.dialog = std::move(dialog);
  return parts;
}

}  // namespace symplant::link::modbus
