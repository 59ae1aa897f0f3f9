// The node ids of the server, and the folders of its nodes.
#include "symplant/link/opc_ua/server_nodes.hpp"

#include <cctype>

namespace symplant::link::opc_ua {

std::string plant_uri(std::string_view prefix, std::string_view plant) {
  std::string uri(prefix);
  for (const char c : plant) {
    const bool kept = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-';
    uri += kept ? c : '-';
  }
  return plant.empty() ? uri + "plant" : uri;
}

Station station_of(std::string_view name) noexcept {
  const std::size_t line = name.find('_');
  if (line == name.npos) return {{}, {}, name};
  const std::size_t process = name.find('_', line + 1);
  if (process == name.npos) return {name.substr(0, line), {}, name.substr(line + 1)};
  return {name.substr(0, line), name.substr(line + 1, process - line - 1), name.substr(process + 1)};
}

}  // namespace symplant::link::opc_ua
