// Addresses of hosts in canonical form.
#pragma once

#include <optional>
#include <string>

namespace symplant::description {

/// A numeric IPv4 or IPv6 address in canonical form: `::1` for `0:0:0:0:0:0:0:1`, `10.0.0.1` for `::ffff:10.0.0.1`.
/// Nothing for any other text.
std::optional<std::string> canonical_ip_address(const std::string& text);

}  // namespace symplant::description
