// Who listens on a port of this machine.
#pragma once

#include <sys/socket.h>
#include <sys/types.h>

#include <optional>
#include <string>

namespace symplant::link::modbus {

struct PortOwner {
  std::string program;  ///< in printable ASCII, cut by the system after 15 bytes
  pid_t process = 0;
};

/// The process that listens where a socket of this address (IPv4 or IPv6, with its port) would: on the port, and on the
/// same address or on all. By /proc; nothing where it cannot be read, as of other users' processes.
std::optional<PortOwner> owner_of_port(const sockaddr& address);

}  // namespace symplant::link::modbus
