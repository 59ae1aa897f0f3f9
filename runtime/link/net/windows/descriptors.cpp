// Windows limits sockets by memory only.
#include "symplant/link/net/descriptors.hpp"

#include <cerrno>

namespace symplant::link::net {

AfterAccept after_accept(int error) noexcept {
  switch (error) {
    case EAGAIN:
      return AfterAccept::serve;
    case EMFILE:
      return AfterAccept::give_way;
    case EINTR:
    case ECONNABORTED:
    case ECONNRESET:
    case ENETDOWN:
      return AfterAccept::again;
    default:
      return AfterAccept::pause;
  }
}

void make_room_for(std::size_t /*clients*/) {}

}  // namespace symplant::link::net
