// A listening TCP socket by HOST:PORT.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "symplant/link/link.hpp"
#include "symplant/link/modbus/socket.hpp"

namespace symplant::link::modbus {

struct HostPort {
  std::string host;  ///< a name or address, an IPv6 address without its brackets
  std::uint16_t port = 0;
};

/// Splits HOST:PORT, [IPv6]:PORT or :PORT; without a host it is the loopback address. Faults are of kind usage.
std::variant<HostPort, LinkError> parse_host_port(std::string_view text);

/// HOST:PORT as it stands in a URL.
std::string format_host_port(const HostPort& address);

struct Listener {
  Descriptor socket;  ///< non-blocking
  HostPort bound;     ///< with the real port
};

/// Binds to the first of the host's addresses that this machine has, those of IPv4 before others, and listens. An
/// unknown host is a fault of kind usage, a port that cannot be had at that address one of kind environment.
std::variant<Listener, LinkError> listen_on(const HostPort& address);

}  // namespace symplant::link::modbus
