// The other end of an accepted TCP connection.
#pragma once

#include <string>

namespace symplant::link::modbus {

/// Sends without delay, and finds a peer that vanished: after 10 s without a word it is asked three times in 15 s, and
/// what it does not acknowledge for 25 s ends the connection.
void prepare_peer(int socket) noexcept;

/// Its numeric address, one of IPv4 also where it came in by IPv6; empty where it is gone.
std::string peer_address(int socket);

}  // namespace symplant::link::modbus
