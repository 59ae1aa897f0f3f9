// A client's socket with deadlines.
#include "symplant/link/net/client_socket.hpp"

#include <array>
#include <utility>

#include "symplant/link/net/peer.hpp"
#include "symplant/link/net/system.hpp"

namespace symplant::link::net {

Ended ClientSocket::failed(int error) {
  fault_ = error_text(error);
  return Ended::closed;
}

Ended ClientSocket::wait_for(Wanted wanted, Deadline deadline) const {
  const Readiness after = net::wait_for(interrupt_.socket(), socket_.get(), wanted, deadline);
  if (after.woken) return Ended::interrupted;
  return after.ready ? Ended::done : Ended::timeout;
}

Ended ClientSocket::wait(Deadline deadline) const { return wait_for({}, deadline); }

Ended ClientSocket::connect_to(const addrinfo& address, Deadline deadline) {
  socket_ = open_socket(address.ai_family, address.ai_socktype);
  if (!socket_) return failed(last_error());
  if (::connect(native(socket_.get()), address.ai_addr, static_cast<socklen_t>(address.ai_addrlen)) != 0 &&
      !is_connecting(last_error())) {
    return failed(last_error());
  }
  if (const Ended ended = wait_for({.write = true}, deadline); ended != Ended::done) return ended;
  if (const int error = pending_error(socket_.get()); error != 0) return failed(error);
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
    const std::ptrdiff_t sent = net::send(socket_.get(), bytes);
    if (sent >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
      continue;
    }
    if (const int error = last_error(); !would_wait(error)) return failed(error);
    if (const Ended ended = wait_for({.write = true}, deadline); ended != Ended::done) return ended;
  }
  return Ended::done;
}

std::size_t ClientSocket::discard() noexcept {
  std::array<std::uint8_t, 4096> room{};
  std::size_t all = 0;
  for (;;) {
    const std::ptrdiff_t count = net::receive(socket_.get(), room);
    if (count <= 0) return all;
    all += static_cast<std::size_t>(count);
  }
}

Ended ClientSocket::receive(std::span<std::uint8_t> room, std::size_t& received, Deadline deadline) {
  for (;;) {
    const std::ptrdiff_t count = net::receive(socket_.get(), room);
    if (count > 0) {
      received = static_cast<std::size_t>(count);
      return Ended::done;
    }
    if (count == 0) {
      fault_ = "the PLC closed the connection";
      return Ended::closed;
    }
    if (const int error = last_error(); !would_wait(error)) return failed(error);
    if (const Ended ended = wait_for({.read = true}, deadline); ended != Ended::done) return ended;
  }
}

}  // namespace symplant::link::net
