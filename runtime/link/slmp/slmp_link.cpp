// The link `slmp`.
#include "symplant/link/slmp/slmp_link.hpp"

#include <memory>
#include <utility>

#include "symplant/link/slmp/map.hpp"
#include "symplant/link/slmp/settings.hpp"
#include "symplant/link/slmp/slmp_dialog.hpp"

namespace symplant::link::slmp {

std::string slmp_fault(std::string_view rest) {
  const auto settings = read_settings(rest);
  const auto* const error = std::get_if<LinkError>(&settings);
  return error == nullptr ? std::string() : error->message;
}

client::PartsResult slmp_parts(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables) {
  auto read = read_settings(rest);
  if (auto* error = std::get_if<LinkError>(&read)) return std::move(*error);
  const Settings& settings = std::get<Settings>(read);
  auto made = make_device_map(tables, link.controller, link.settings, settings);
  if (auto* error = std::get_if<LinkError>(&made)) return std::move(*error);
  DeviceMap& map = std::get<DeviceMap>(made);
  client::ClientParts parts{.dialog = nullptr,
                            .map = map.image,
                            .addresses = {},
                            .word_orders = map.word_orders,
                            .unreachable = map.unreachable,
                            .times = settings.times,
                            .notes = {}};
  for (const Device& device : map.devices) parts.addresses.push_back(device_text(device, settings.framing.family));
  auto dialog = std::make_unique<SlmpDialog>(settings, std::move(map));
  parts.notes = dialog->notes();
  parts.dialog = std::move(dialog);
  return parts;
}

}  // namespace symplant::link::slmp
