// The link `slmp`.
#include "symplant/link/slmp/slmp_link.hpp"

#include <algorithm>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "symplant/link/client/client_link.hpp"
#include "symplant/link/slmp/map.hpp"
#include "symplant/link/slmp/settings.hpp"
#include "symplant/link/slmp/slmp_dialog.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::slmp {

namespace {

/// "3 symbols are not linked: `A` has no address, ...": at most three by name.
std::vector<std::string> notes_of(const DeviceMap& map, const tables::PlantTables& tables) {
  constexpr std::size_t kNamed = 3;
  if (map.unreachable.empty()) return {};
  const auto texts = tables::split_names(tables.symbol_names);
  const std::size_t count = map.unreachable.size();
  std::string note = std::to_string(count) + (count == 1 ? " symbol is" : " symbols are") + " not linked: ";
  for (std::size_t i = 0; i < std::min(count, kNamed); ++i) {
    const Unreachable& one = map.unreachable[i];
    note.append(i == 0 ? "`" : ", `").append(texts[std::size_t{2} * one.symbol]).append("` ").append(one.reason);
  }
  if (count > kNamed) note += ", ...";
  return {note + "; `map=SYMBOL:DEVICE` in the URL links a symbol"};
}

}  // namespace

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
  std::vector<std::string> notes = notes_of(map, tables);
  try {
    auto dialog = std::make_unique<SlmpDialog>(settings, std::move(map), std::move(notes));
    return client::open_client_link(std::move(dialog), io, link.settings, settings.times, tables, plant);
  } catch (const std::system_error& error) {
    return LinkError{LinkError::Kind::environment, std::string("cannot start the link: ") + error.what()};
  }
}

}  // namespace symplant::link::slmp
