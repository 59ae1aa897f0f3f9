// The link `slmp`.
#include "symplant/link/slmp/slmp_link.hpp"

#include <memory>
#include <system_error>
#include <utility>

#include "symplant/link/client/client_link.hpp"
#include "symplant/link/slmp/map.hpp"
#include "symplant/link/slmp/settings.hpp"
#include "symplant/link/slmp/slmp_dialog.hpp"

namespace symplant::link::slmp {

std::string slmp_fault(std::string_view rest) {
  const auto settings = read_settings(rest);
  const auto* const error = std::get_if<LinkError>(&settings);
  return error == nullptr ? std::string() : error->message;
}

LinkResult open_slmp_link(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                          const plant::Plant* plant) {
  auto read = read_settings(rest);
  if (auto* error = std::get_if<LinkError>(&read)) return std::move(*error);
  const Settings& settings = std::get<Settings>(read);
  auto made = make_device_map(tables, link.controller, link.settings, settings);
  if (auto* error = std::get_if<LinkError>(&made)) return std::move(*error);
  DeviceMap& map = std::get<DeviceMap>(made);
  const IoMap io = map.io;
  try {
    auto dialog = std::make_unique<SlmpDialog>(settings, std::move(map));
    return client::open_client_link(std::move(dialog), io, link.settings, settings.times, tables, plant);
  } catch (const std::system_error& error) {
    return LinkError{LinkError::Kind::environment, std::string("cannot start the link: ") + error.what()};
  }
}

}  // namespace symplant::link::slmp
