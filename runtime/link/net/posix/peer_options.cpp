// Options of a connection, and what its peer has not acknowledged, by Linux.
#include <linux/sockios.h>
#include <netinet/tcp.h>
#include <sys/ioctl.h>

#include <algorithm>

#include "symplant/link/net/peer.hpp"
#include "symplant/link/net/system.hpp"

namespace symplant::link::net {
namespace {

constexpr int kSilentSeconds = 10;
constexpr int kBetweenProbesSeconds = 5;
constexpr int kProbes = 3;
constexpr int kUnacknowledgedMilliseconds = 25'000;

void set(int socket, int level, int option, int value) noexcept {
  ::setsockopt(socket, level, option, &value, sizeof value);
}

}  // namespace

void prepare_peer(int socket) noexcept {
  set(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set(socket, IPPROTO_TCP, TCP_KEEPIDLE, kSilentSeconds);
  set(socket, IPPROTO_TCP, TCP_KEEPINTVL, kBetweenProbesSeconds);
  set(socket, IPPROTO_TCP, TCP_KEEPCNT, kProbes);
  set(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, kUnacknowledgedMilliseconds);
}

std::size_t unacknowledged(int socket) noexcept {
  int waiting = 0;
  if (::ioctl(socket, SIOCOUTQ, &waiting) != 0) return 0;
  return static_cast<std::size_t>(std::max(waiting, 0));
}

}  // namespace symplant::link::net
