// Who listens on a port of this machine.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>

namespace symplant::link::modbus {

struct PortOwner {
  std::string program;  ///< in printable ASCII, cut by the system after 15 bytes
  pid_t process = 0;
};

/// The process that listens on a TCP port, by /proc; nothing where it cannot be read, as of other users' processes.
std::optional<PortOwner> owner_of_port(std::uint16_t port);

}  // namespace symplant::link::modbus
