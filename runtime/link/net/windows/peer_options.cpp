// Options of a connection by Winsock (Windows 10 1709).
#include "symplant/link/net/peer.hpp"
#include "symplant/link/net/system.hpp"

namespace symplant::link::net {
namespace {

// TCP_KEEPIDLE, TCP_MAXRT, TCP_KEEPCNT and TCP_KEEPINTVL; older headers do not define them.
constexpr int kKeepIdle = 3;
constexpr int kMostSilence = 5;
constexpr int kKeepCount = 16;
constexpr int kKeepInterval = 17;

constexpr int kSilentSeconds = 10;
constexpr int kBetweenProbesSeconds = 5;
constexpr int kProbes = 3;
constexpr int kUnacknowledgedSeconds = 25;

void set(int socket, int level, int option, int value) noexcept {
  ::setsockopt(native(socket), level, option, reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

void prepare_peer(int socket) noexcept {
  set(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set(socket, IPPROTO_TCP, kKeepIdle, kSilentSeconds);
  set(socket, IPPROTO_TCP, kKeepInterval, kBetweenProbesSeconds);
  set(socket, IPPROTO_TCP, kKeepCount, kProbes);
  set(socket, IPPROTO_TCP, kMostSilence, kUnacknowledgedSeconds);
}

// Windows does not show it: what the system has taken counts as acknowledged.
std::size_t unacknowledged(int /*socket*/) noexcept { return 0; }

}  // namespace symplant::link::net
