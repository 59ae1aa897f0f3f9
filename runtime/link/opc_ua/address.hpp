// URLs of the links of OPC UA: host, port, path and parameters.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "symplant/link/link.hpp"
#include "symplant/link/net/host_port.hpp"
#include "symplant/link/url.hpp"

namespace symplant::link::opc_ua {

/// An invalid URL.
inline LinkError usage_error(std::string message) { return {LinkError::Kind::usage, std::move(message)}; }

struct Address {
  net::HostPort at;
  std::string path;  ///< "/a/b", or empty
  std::vector<UrlParameter> parameters;
};

/// Parses `//HOST:PORT/PATH?key=value&key=value`, the URL after `scheme:`; path and parameters may be absent. Errors
/// are of kind usage. Port 0 is valid. O(length).
std::variant<Address, LinkError> parse_address(std::string_view rest, std::string_view scheme);

}  // namespace symplant::link::opc_ua
