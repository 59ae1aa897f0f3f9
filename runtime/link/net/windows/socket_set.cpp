// Many sockets by WSAPoll.
#include "symplant/link/net/socket_set.hpp"

#include <algorithm>
#include <vector>

#include "symplant/link/net/system.hpp"

namespace symplant::link::net {
namespace {

short events_of(Wanted wanted) { return static_cast<short>((wanted.read ? POLLIN : 0) | (wanted.write ? POLLOUT : 0)); }

}  // namespace

struct SocketSet::Parts {
  WSAPOLLFD* find(int socket) {
    const auto found =
        std::find_if(watched.begin(), watched.end(), [&](const WSAPOLLFD& each) { return each.fd == native(socket); });
    return found == watched.end() ? nullptr : &*found;
  }

  std::vector<WSAPOLLFD> watched;
  std::vector<Ready> ready;
};

SocketSet::SocketSet() : parts_(std::make_unique<Parts>()) {}

SocketSet::~SocketSet() = default;

bool SocketSet::add(int socket, Wanted wanted) noexcept {
  parts_->watched.push_back({native(socket), events_of(wanted), 0});
  return true;
}

bool SocketSet::change(int socket, Wanted wanted) noexcept {
  WSAPOLLFD* const found = parts_->find(socket);
  if (found != nullptr) found->events = events_of(wanted);
  return found != nullptr;
}

void SocketSet::remove(int socket) noexcept {
  std::erase_if(parts_->watched, [&](const WSAPOLLFD& each) { return each.fd == native(socket); });
}

std::span<const SocketSet::Ready> SocketSet::wait(int milliseconds) noexcept {
  parts_->ready.clear();
  if (::WSAPoll(parts_->watched.data(), static_cast<ULONG>(parts_->watched.size()), milliseconds) <= 0) return {};
  for (const WSAPOLLFD& each : parts_->watched) {
    if (each.revents == 0) continue;
    parts_->ready.push_back({static_cast<int>(each.fd), (each.revents & (POLLIN | POLLHUP | POLLERR | POLLNVAL)) != 0,
                             (each.revents & POLLOUT) != 0});
  }
  return parts_->ready;
}

}  // namespace symplant::link::net
