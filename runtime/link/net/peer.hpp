// The other end of an accepted TCP connection.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace symplant::link::net {

/// Sets the socket options: send without delay, detect a peer that vanished. After 10 s of silence it is probed three
/// times in 15 s; data that it does not acknowledge within 25 s ends the connection.
void prepare_peer(int socket) noexcept;

/// Bytes that the system has taken and the peer has not acknowledged; 0 if unknown.
std::size_t unacknowledged(int socket) noexcept;

/// The numeric address of the peer, an IPv4 address also if it is mapped to IPv6; empty if the peer is gone.
std::string peer_address(int socket);

/// The same as a number, the first of its four bytes in the highest bits; 0 if it is no IPv4 address, or the peer is
/// gone.
std::uint32_t peer_ipv4(int socket) noexcept;

}  // namespace symplant::link::net
