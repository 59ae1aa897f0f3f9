// Limits of Linux on sockets.
#include "symplant/link/net/descriptors.hpp"

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include "symplant/link/net/posix/file_limit.hpp"

namespace symplant::link::net {

namespace {

constexpr rlim_t kOtherFiles = 32;  ///< ample for all descriptors of the process but its clients

}  // namespace

bool concerns_client(int error) noexcept {
  switch (error) {
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
      return true;
    default:
      return false;
  }
}

std::optional<rlim_t> limit_for(rlimit limit, std::size_t clients) noexcept {
  if (limit.rlim_max < clients + kOtherFiles) return std::nullopt;
  if (limit.rlim_max - clients <= limit.rlim_cur) return limit.rlim_max;
  return limit.rlim_cur + clients;
}

void make_room_for(std::size_t clients) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  const auto wanted = limit_for(limit, clients);
  if (!wanted) {
    throw std::system_error(EMFILE, std::generic_category(),
                            std::to_string(clients) + " connections do not fit in the " +
                                std::to_string(limit.rlim_max) +
                                " files that this process may open, give fewer `connections` or raise `ulimit -Hn`");
  }
  limit.rlim_cur = std::max(*wanted, limit.rlim_cur);
  // Raising it up to the hard limit needs no privilege.
  if (::setrlimit(RLIMIT_NOFILE, &limit) != 0) throw std::system_error(errno, std::generic_category(), "setrlimit");
}

}  // namespace symplant::link::net
