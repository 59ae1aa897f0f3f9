// The process that listens on a port of this machine.
#pragma once

#include <sys/socket.h>
#include <sys/types.h>

#include <optional>
#include <string>

namespace symplant::link::net {

struct PortOwner {
  std::string program;  ///< in printable ASCII; the system cuts it after 15 bytes
  pid_t process = 0;
};

/// The process whose listening socket collides with this address (IPv4 or IPv6, with its port): one on the same port,
/// and on the same address or on all. Reads /proc; nothing if that is not readable, as for processes of other users.
std::optional<PortOwner> owner_of_port(const sockaddr& address);

}  // namespace symplant::link::net
