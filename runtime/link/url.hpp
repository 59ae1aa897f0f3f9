// URLs of links that go to a PLC: host, port and parameters.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/link/link.hpp"
#include "symplant/link/net/host_port.hpp"

namespace symplant::link {

struct UrlParameter {
  std::string key;
  std::string value;
};

struct ParsedUrl {
  net::HostPort address;
  std::vector<UrlParameter> parameters;  ///< in their order; only `map` may be there more than once
};

/// Parses `//HOST:PORT?key=value&key=value`, the URL after `scheme:`. `%XX` is a byte. Port 0, a text that is
/// not such a URL, and a repeated key are errors of kind usage.
std::variant<ParsedUrl, LinkError> parse_url(std::string_view rest, std::string_view scheme);

}  // namespace symplant::link
