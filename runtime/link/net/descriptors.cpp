// What a server does after a failed accept().
#include "symplant/link/net/descriptors.hpp"

#include <cerrno>

namespace symplant::link::net {

AfterAccept after_accept(int error) noexcept {
  if (error == EAGAIN) return AfterAccept::serve;
  if (error == EMFILE) return AfterAccept::give_way;
  return concerns_client(error) ? AfterAccept::again : AfterAccept::pause;
}

}  // namespace symplant::link::net
