// What a peer has not acknowledged, by Linux.
#include <linux/sockios.h>
#include <sys/ioctl.h>

#include <algorithm>

#include "symplant/link/net/peer.hpp"

namespace symplant::link::net {

std::size_t unacknowledged(int socket) noexcept {
  int waiting = 0;
  if (::ioctl(socket, SIOCOUTQ, &waiting) != 0) return 0;
  return static_cast<std::size_t>(std::max(waiting, 0));
}

}  // namespace symplant::link::net
