// What a peer has not acknowledged: Windows does not show it.
#include "symplant/link/net/peer.hpp"

namespace symplant::link::net {

std::size_t unacknowledged(int /*socket*/) noexcept { return 0; }

}  // namespace symplant::link::net
