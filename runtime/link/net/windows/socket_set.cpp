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
  struct Watched {
    int socket;
    Wanted wanted;
  };
  auto find(int socket) {
    return std::find_if(watched.begin(), watched.end(), [&](const Watched& each) { return each.socket == socket; });
  }

  std::vector<Watched> watched;
  std::vector<WSAPOLLFD> polled;
  std::vector<Ready> ready;
};

SocketSet::SocketSet() : parts_(std::make_unique<Parts>()) {}

SocketSet::~SocketSet() = default;

bool SocketSet::add(int socket, Wanted wanted) noexcept {
  parts_->watched.push_back({socket, wanted});
  return true;
}

bool SocketSet::change(int socket, Wanted wanted) noexcept {
  const auto found = parts_->find(socket);
  if (found == parts_->watched.end()) return false;
  found->wanted = wanted;
  return true;
}

void SocketSet::remove(int socket) noexcept {
  const auto found = parts_->find(socket);
  if (found != parts_->watched.end()) parts_->watched.erase(found);
}

// A peer that has ended its half is reported in each call, wanted or not: only to one that reads. Of a socket of which
// nothing is wanted, nothing is asked.
std::span<const SocketSet::Ready> SocketSet::wait(int milliseconds) noexcept {
  parts_->polled.clear();
  parts_->ready.clear();
  for (const Parts::Watched& each : parts_->watched) {
    const bool is_idle = !each.wanted.read && !each.wanted.write;
    parts_->polled.push_back({is_idle ? INVALID_SOCKET : native(each.socket), events_of(each.wanted), 0});
  }
  if (::WSAPoll(parts_->polled.data(), static_cast<ULONG>(parts_->polled.size()), milliseconds) <= 0) return {};
  for (std::size_t i = 0; i < parts_->polled.size(); ++i) {
    const short events = parts_->polled[i].revents;
    const Parts::Watched& each = parts_->watched[i];
    const bool has_failed = (events & (POLLERR | POLLNVAL)) != 0;
    const bool can_read = has_failed || (each.wanted.read && (events & (POLLIN | POLLHUP)) != 0);
    const bool can_write = (events & POLLOUT) != 0;
    if (can_read || can_write) parts_->ready.push_back({each.socket, can_read, can_write});
  }
  return parts_->ready;
}

}  // namespace symplant::link::net
