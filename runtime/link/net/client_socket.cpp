// A client's socket with deadlines.
#include "symplant/link/net/client_socket.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "symplant/link/net/peer.hpp"

namespace symplant::link::net {

namespace {

using std::chrono::steady_clock;

/// For ppoll(): the time left, not negative.
timespec time_left(Deadline deadline) {
  const auto left = std::max(deadline - steady_clock::now(), steady_clock::duration::zero());
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
  return {.tv_sec = static_cast<time_t>(seconds.count()), .tv_nsec = static_cast<long>((left - seconds).count())};
}

}  // namespace

ClientSocket::ClientSocket() : interrupt_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (!interrupt_) throw std::system_error(errno, std::generic_category(), "eventfd");
}

void ClientSocket::interrupt() noexcept { ::eventfd_write(interrupt_.get(), 1); }

Ended ClientSocket::failed(int error) {
  fault_ = std::generic_category().message(error);
  return Ended::closed;
}

Ended ClientSocket::wait_for(short events, Deadline deadline) const {
  std::array<pollfd, 2> watched{pollfd{interrupt_.get(), POLLIN, 0}, pollfd{socket_.get(), events, 0}};
  for (;;) {
    const timespec left = time_left(deadline);
    const int ready = ::ppoll(watched.data(), events == 0 ? 1 : 2, &left, nullptr);
    if (ready < 0 && errno == EINTR) continue;
    if (watched[0].revents != 0) return Ended::interrupted;
    return ready > 0 ? Ended::done : Ended::timeout;
  }
}

Ended ClientSocket::wait(Deadline deadline) const { return wait_for(0, deadline); }

Ended ClientSocket::connect_to(const addrinfo& address, Deadline deadline) {
  socket_ = Descriptor(::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!socket_) return failed(errno);
  if (::connect(socket_.get(), address.ai_addr, address.ai_addrlen) != 0 && errno != EINPROGRESS) return failed(errno);
  if (const Ended ended = wait_for(POLLOUT, deadline); ended != Ended::done) return ended;
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(socket_.get(), SOL_SOCKET, SO_ERROR, &error, &size);
  if (error != 0) return failed(error);
  if (address.ai_socktype == SOCK_STREAM) prepare_peer(socket_.get());
  return Ended::done;
}

Ended ClientSocket::connect(const HostPort& address, Transport transport, Deadline deadline) {
  auto resolved = resolve(address, transport == Transport::tcp ? SOCK_STREAM : SOCK_DGRAM, false);
  if (auto* error = std::get_if<LinkError>(&resolved)) {
    fault_ = std::move(error->message);
    return Ended::closed;
  }
  Ended ended = Ended::closed;
  for (const addrinfo* one : ipv4_first(std::get<Addresses>(resolved).get())) {
    ended = connect_to(*one, deadline);
    if (ended != Ended::closed) break;
  }
  if (ended != Ended::done) close();
  return ended;
}

Ended ClientSocket::send(std::span<const std::uint8_t> bytes, Deadline deadline) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      if (const Ended ended = wait_for(POLLOUT, deadline); ended != Ended::done) return ended;
    } else if (errno != EINTR) {
      return failed(errno);
    }
  }
  return Ended::done;
}

std::size_t ClientSocket::discard() noexcept {
  std::array<std::uint8_t, 4096> room{};
  std::size_t all = 0;
  for (;;) {
    const ssize_t count = ::recv(socket_.get(), room.data(), room.size(), MSG_DONTWAIT);
    if (count <= 0) return all;
    all += static_cast<std::size_t>(count);
  }
}

Ended ClientSocket::receive(std::span<std::uint8_t> room, std::size_t& received, Deadline deadline) {
  for (;;) {
    const ssize_t count = ::recv(socket_.get(), room.data(), room.size(), 0);
    if (count > 0) {
      received = static_cast<std::size_t>(count);
      return Ended::done;
    }
    if (count == 0) {
      fault_ = "the PLC closed the connection";
      return Ended::closed;
    }
    if (errno == EAGAIN || errno == EWOULDBLOCK) {
      if (const Ended ended = wait_for(POLLIN, deadline); ended != Ended::done) return ended;
    } else if (errno != EINTR) {
      return failed(errno);
    }
  }
}

}  // namespace symplant::link::net
