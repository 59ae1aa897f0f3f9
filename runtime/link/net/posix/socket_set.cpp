// Many sockets by Linux's epoll.
#include "symplant/link/net/socket_set.hpp"

#include <sys/epoll.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace symplant::link::net {
namespace {

constexpr std::size_t kMostAtOnce = 64;

std::uint32_t events_of(Wanted wanted) {
  return (wanted.read ? std::uint32_t{EPOLLIN} : 0U) | (wanted.write ? std::uint32_t{EPOLLOUT} : 0U);
}

}  // namespace

struct SocketSet::Parts {
  bool control(int operation, int socket, Wanted wanted) const noexcept {
    epoll_event event{};
    event.events = events_of(wanted);
    event.data.fd = socket;
    return ::epoll_ctl(epoll.get(), operation, socket, &event) == 0;
  }

  Descriptor epoll{::epoll_create1(EPOLL_CLOEXEC)};
  std::array<Ready, kMostAtOnce> ready{};
};

SocketSet::SocketSet() : parts_(std::make_unique<Parts>()) {
  if (!parts_->epoll) throw std::system_error(errno, std::generic_category(), "epoll_create1");
}

SocketSet::~SocketSet() = default;

bool SocketSet::add(int socket, Wanted wanted) noexcept { return parts_->control(EPOLL_CTL_ADD, socket, wanted); }
bool SocketSet::change(int socket, Wanted wanted) noexcept { return parts_->control(EPOLL_CTL_MOD, socket, wanted); }

// Closing the socket removes it.
void SocketSet::remove(int /*socket*/) noexcept {}

std::span<const SocketSet::Ready> SocketSet::wait(int milliseconds) noexcept {
  std::array<epoll_event, kMostAtOnce> events{};
  const int count = ::epoll_wait(parts_->epoll.get(), events.data(), static_cast<int>(events.size()), milliseconds);
  const auto size = count < 0 ? std::size_t{0} : static_cast<std::size_t>(count);
  for (std::size_t i = 0; i < size; ++i) {
    parts_->ready[i] = {events[i].data.fd, (events[i].events & (EPOLLIN | EPOLLHUP | EPOLLERR)) != 0,
                        (events[i].events & EPOLLOUT) != 0};
  }
  return {parts_->ready.data(), size};
}

}  // namespace symplant::link::net
