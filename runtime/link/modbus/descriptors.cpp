// What the system allows of sockets: what follows when a client cannot be accepted.
#include "symplant/link/modbus/descriptors.hpp"

#include <cerrno>

namespace symplant::link::modbus {

AfterAccept after_accept(int error) noexcept {
  switch (error) {
    case EAGAIN:
      return AfterAccept::serve;
    case EMFILE:
      return AfterAccept::give_way;
    case EINTR:
    case ECONNABORTED:
    case EPERM:  // a firewall
    case EPROTO:
    case ENOPROTOOPT:
    case EOPNOTSUPP:
    case ENETDOWN:
    case ENETUNREACH:
    case EHOSTDOWN:
    case EHOSTUNREACH:
    case ENONET:
      return AfterAccept::again;
    default:
      return AfterAccept::pause;
  }
}

}  // namespace symplant::link::modbus
