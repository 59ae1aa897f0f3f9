// The other end of an accepted TCP connection.
#pragma once

#include <string>

namespace symplant::link::net {

/// Sets the socket options: send without delay, detect a peer that vanished. After 10 s of silence it is probed three
/// times in 15 s; data that it does not acknowledge within 25 s ends the connection.
void prepare_peer(int socket) noexcept;

/// The numeric address of the peer, an IPv4 address also if it is mapped to IPv6; empty if the peer is gone.
std::string peer_address(int socket);

}  // namespace symplant::link::net
