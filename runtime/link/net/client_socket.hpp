// A client's socket: every call ends at a deadline, or when another thread interrupts it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "symplant/link/net/host_port.hpp"
#include "symplant/link/net/socket.hpp"

namespace symplant::link::net {

enum class Transport : std::uint8_t { tcp, udp };

/// How a call of a ClientSocket ended.
enum class Ended : std::uint8_t {
  done,
  timeout,      ///< the deadline came first
  closed,       ///< by the peer, or the connection failed; ClientSocket::fault() has the reason
  interrupted,  ///< by interrupt()
};

/// A connection to one server, used by one thread; only interrupt() may be called by another.
class ClientSocket {
 public:
  /// Throws std::system_error if the process has no descriptor left.
  ClientSocket() = default;

  /// Connects to the first address of the host that accepts. After a failure the socket is closed. May wait for a name
  /// server before it looks at the deadline.
  Ended connect(const HostPort& address, Transport transport, Deadline deadline);
  /// Sends all bytes; by UDP as one datagram.
  Ended send(std::span<const std::uint8_t> bytes, Deadline deadline);
  /// Waits for bytes and receives at least one, or one datagram, which is cut to `room`.
  Ended receive(std::span<std::uint8_t> room, std::size_t& received, Deadline deadline);
  /// Discards the bytes that have already arrived. Returns their number.
  std::size_t discard() noexcept;
  void close() noexcept { socket_ = Descriptor(); }
  bool is_open() const noexcept { return static_cast<bool>(socket_); }

  /// Sleeps until the deadline (`timeout`) or an interruption.
  Ended wait(Deadline deadline) const;
  /// Ends the current call and all later ones. Any thread.
  void interrupt() noexcept { interrupt_.wake(); }

  /// Why the latest call ended as `closed`: "connection refused".
  const std::string& fault() const noexcept { return fault_; }

 private:
  Ended wait_for(Wanted wanted, Deadline deadline) const;
  Ended connect_to(const addrinfo& address, Deadline deadline);
  Ended failed(int error);

  Descriptor socket_;
  Wakeup interrupt_;
  std::string fault_;
};

}  // namespace symplant::link::net
