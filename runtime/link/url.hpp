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

/// Parses `key=value&key=value`. `%XX` is a byte of a value, in which `=` and `"` need no `%`. A text that is not a
/// setting, and a repeated key, are errors of kind usage.
std::variant<std::vector<UrlParameter>, LinkError> parse_parameters(std::string_view query);

/// Parses `//HOST:PORT?key=value&key=value`, the URL after `scheme:`, as parse_parameters(). Port 0 and a
/// text that is not such a URL are errors of kind usage, too.
std::variant<ParsedUrl, LinkError> parse_url(std::string_view rest, std::string_view scheme);

}  // namespace symplant::link
