// Opens a listening TCP socket from HOST:PORT.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "symplant/link/link.hpp"
#include "symplant/link/modbus/socket.hpp"

namespace symplant::link::modbus {

struct HostPort {
  std::string host;  ///< a name or an address; an IPv6 address without brackets
  std::uint16_t port = 0;
};

/// Splits HOST:PORT, [IPv6]:PORT or :PORT (the loopback address). Errors are of kind usage.
std::variant<HostPort, LinkError> parse_host_port(std::string_view text);

/// HOST:PORT as in a URL.
std::string format_host_port(const HostPort& address);

struct Listener {
  Descriptor socket;  ///< non-blocking
  HostPort bound;     ///< with the real port
};

/// Binds to the first of the host's addresses that this machine has, IPv4 before IPv6, and listens. An unknown host is
/// an error of kind usage, a port that is not available at that address an error of kind environment.
std::variant<Listener, LinkError> listen_on(const HostPort& address);

}  // namespace symplant::link::modbus
