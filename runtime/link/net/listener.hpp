// Opens a listening TCP socket at a host and port.
#pragma once

#include <variant>

#include "symplant/link/link.hpp"
#include "symplant/link/net/host_port.hpp"
#include "symplant/link/net/socket.hpp"

namespace symplant::link::net {

struct Listener {
  Descriptor socket;  ///< non-blocking
  HostPort bound;     ///< with the real port
};

/// Binds to the first of the host's addresses that this machine has, IPv4 before IPv6, and listens. An unknown host is
/// an error of kind usage, a port that is not available at that address an error of kind environment.
std::variant<Listener, LinkError> listen_on(const HostPort& address);

}  // namespace symplant::link::net
