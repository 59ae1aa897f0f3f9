// The node ids of the server.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace symplant::link::opc_ua {

/// The index of the namespace `urn:symplant:PLANT`: the first after those that each server has.
inline constexpr std::uint16_t kPlantNamespace = 2;

/// The node id of a symbol's variable, as text: `ns=2;s=NAME`.
inline std::string symbol_node_text(std::string_view name) {
  return "ns=" + std::to_string(kPlantNamespace) + ";s=" + std::string(name);
}

}  // namespace symplant::link::opc_ua
