// Sockets by POSIX and Linux.
#include "symplant/link/net/socket.hpp"

#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "symplant/link/net/system.hpp"

namespace symplant::link::net {
namespace {

using std::chrono::steady_clock;

/// For ppoll(): the time left, not negative.
timespec time_left(Deadline deadline) {
  const auto left = std::max(deadline - steady_clock::now(), steady_clock::duration::zero());
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
  return {.tv_sec = static_cast<time_t>(seconds.count()), .tv_nsec = static_cast<long>((left - seconds).count())};
}

/// Again if a signal interrupted it.
template <class Call>
auto uninterrupted(Call call) noexcept {
  for (;;) {
    const auto result = call();
    if (result >= 0 || errno != EINTR) return result;
  }
}

}  // namespace

void start_sockets() noexcept {}

void close_socket(int socket) noexcept { ::close(socket); }

int last_error() noexcept { return errno; }
std::string error_text(int error) { return std::generic_category().message(error); }
bool would_wait(int error) noexcept { return error == EAGAIN || error == EWOULDBLOCK; }
bool is_connecting(int error) noexcept { return error == EINPROGRESS; }

Descriptor open_socket(int family, int type) noexcept {
  return Descriptor(::socket(family, type | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

Descriptor accept_client(int listener) noexcept {
  return Descriptor(::accept4(listener, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
}

void take_port_soon(int socket) noexcept {
  const int on = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
}

bool is_taken(int error) noexcept { return error == EADDRINUSE; }

std::string how_to_get_port(std::uint16_t port) {
  constexpr int kFirstFree = 1024;  // ports below it need a privilege
  if (port >= kFirstFree) return "give another port";
  return "give one from 1024 on, or allow this program the lower ones by `sudo setcap cap_net_bind_service=+ep "
         "PROGRAM`";
}

int pending_error(int socket) noexcept {
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

std::ptrdiff_t receive(int socket, std::span<std::uint8_t> room) noexcept {
  return uninterrupted([&] { return ::recv(socket, room.data(), room.size(), MSG_DONTWAIT); });
}

std::ptrdiff_t send(int socket, std::span<const std::uint8_t> bytes) noexcept {
  return uninterrupted([&] { return ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT); });
}

Wakeup::Wakeup() : read_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (!read_) throw std::system_error(errno, std::generic_category(), "eventfd");
}

void Wakeup::wake() noexcept { ::eventfd_write(read_.get(), 1); }

Readiness wait_for(int wakeup, int socket, Wanted wanted, Deadline deadline) noexcept {
  const auto events = static_cast<short>((wanted.read ? POLLIN : 0) | (wanted.write ? POLLOUT : 0));
  std::array<pollfd, 2> watched{pollfd{wakeup, POLLIN, 0}, pollfd{socket, events, 0}};
  for (;;) {
    const timespec left = time_left(deadline);
    const int ready = ::ppoll(watched.data(), events == 0 ? 1 : 2, &left, nullptr);
    if (ready < 0 && errno == EINTR) continue;
    return {watched[0].revents != 0, ready > 0 && watched[1].revents != 0};
  }
}

}  // namespace symplant::link::net
