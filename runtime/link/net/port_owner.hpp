// The process that listens on a port of this machine.
#pragma once

#include <optional>
#include <string>

#include "symplant/link/net/system.hpp"

namespace symplant::link::net {

struct PortOwner {
  std::string program;  ///< in printable ASCII; the system cuts it after 15 bytes
  unsigned long process = 0;
  bool is_this = false;  ///< the calling process
};

/// The process whose listening socket collides with this address (IPv4 or IPv6, with its port): one on the same port,
/// and on the same address or on all. Nothing if the system does
/// not show it, as Linux for processes of other users.
std::optional<PortOwner> owner_of_port(const sockaddr& address);

/// A command of the system that shows it.
const char* how_to_find_owner();

}  // namespace symplant::link::net
