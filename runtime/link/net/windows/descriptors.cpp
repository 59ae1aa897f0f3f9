// Windows limits sockets by memory only.
#include "symplant/link/net/descriptors.hpp"

#include <cerrno>

namespace symplant::link::net {

bool concerns_client(int error) noexcept {
  return error == EINTR || error == ECONNABORTED || error == ECONNRESET || error == ENETDOWN;
}

void make_room_for(std::size_t /*clients*/) {}

}  // namespace symplant::link::net
