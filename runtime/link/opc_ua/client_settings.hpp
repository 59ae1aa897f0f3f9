// The settings of a link `opc-ua`: the parameters of its URL.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/net/host_port.hpp"
#include "symplant/link/opc_ua/security.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::opc_ua {

inline constexpr std::string_view kClientScheme = "opc-ua";

struct ClientSettings {
  net::HostPort address;
  std::string path;   ///< "/a/b", or empty
  std::string nodes;  ///< template of node ids, with {symbol} and {address}; empty: plant.json has them
  SecuritySettings security;
  tables::Time timeout = 800 * tables::kMillisecond;  ///< of one answer; by default less than LinkSettings::loss_after
  client::ClientTimes times = {.read_back = tables::kSecond};
};

/// Reads `//HOST:PORT/PATH?nodes=...`, the URL after `opc-ua:`. Errors are of kind usage. O(length).
std::variant<ClientSettings, LinkError> read_client_settings(std::string_view rest);

/// Why `rest` is invalid; empty if it is valid.
std::string client_fault(std::string_view rest);

}  // namespace symplant::link::opc_ua
