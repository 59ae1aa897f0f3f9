// The system's declarations of sockets, addresses and poll().
#pragma once

#ifdef _WIN32

#include <winsock2.h>
// Each needs winsock2.h before it.
#include <ws2tcpip.h>

#else

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#endif

namespace symplant::link::net {

#ifdef _WIN32
/// As Winsock wants it; handles of sockets are numbers below 2^31.
constexpr SOCKET native(int socket) noexcept { return static_cast<SOCKET>(socket); }
#else
constexpr int native(int socket) noexcept { return socket; }
#endif

}  // namespace symplant::link::net
