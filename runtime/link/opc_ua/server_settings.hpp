// The settings of a link `opc-ua-server`: the parameters of its URL.
#pragma once

#include <string_view>
#include <variant>

#include "symplant/link/link.hpp"
#include "symplant/link/net/host_port.hpp"
#include "symplant/link/opc_ua/security.hpp"

namespace symplant::link::opc_ua {

inline constexpr std::string_view kServerScheme = "opc-ua-server";

struct ServerSettings {
  net::HostPort address;
  SecuritySettings security;
};

/// Reads `//HOST:PORT?security=encrypt&...`, the URL after `opc-ua-server:`. Errors are of kind usage. O(length).
std::variant<ServerSettings, LinkError> read_server_settings(std::string_view rest);

}  // namespace symplant::link::opc_ua
