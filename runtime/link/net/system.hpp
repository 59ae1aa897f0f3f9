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
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#endif

namespace symplant::link::net {

#ifdef _WIN32
// Options of TCP, which older headers do not define.
inline constexpr int kKeepIdle = 3;
inline constexpr int kKeepInterval = 17;
inline constexpr int kKeepCount = 16;
inline constexpr int kLongestSilence = 5;  ///< TCP_MAXRT
inline constexpr int kSilenceUnits = 1;    ///< in a second

/// As Winsock wants it; handles of sockets are numbers below 2^31.
constexpr SOCKET native(int socket) noexcept { return static_cast<SOCKET>(socket); }
#else
inline constexpr int kKeepIdle = TCP_KEEPIDLE;
inline constexpr int kKeepInterval = TCP_KEEPINTVL;
inline constexpr int kKeepCount = TCP_KEEPCNT;
inline constexpr int kLongestSilence = TCP_USER_TIMEOUT;
inline constexpr int kSilenceUnits = 1000;  ///< in a second

constexpr int native(int socket) noexcept { return socket; }
#endif

}  // namespace symplant::link::net
