// A Modbus client of raw bytes: sends any bytes, cut anywhere.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "symplant/link/net/socket.hpp"

namespace symplant::test {

/// CPU time of this process.
inline std::size_t open_descriptors() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

using Bytes = std::vector<std::uint8_t>;

/// A TCP client on the loopback that waits for data; a time limit only lets a failed test end.
class RawClient {
 public:
  /// With `room`, the bytes that the connection takes before they are received are about this number.
  explicit RawClient(std::uint16_t port, int family = AF_INET, int room = 0)
      : socket_(::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const int on = 1;
    ::setsockopt(socket_.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    if (room != 0) ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
    sockaddr_in v4{};
    v4.sin_family = AF_INET;
    v4.sin_port = htons(port);
    v4.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    sockaddr_in6 v6{};
    v6.sin6_family = AF_INET6;
    v6.sin6_port = htons(port);
    v6.sin6_addr = in6addr_loopback;
    const auto* address =
        family == AF_INET ? reinterpret_cast<const sockaddr*>(&v4) : reinterpret_cast<const sockaddr*>(&v6);
    const socklen_t size = family == AF_INET ? sizeof v4 : sizeof v6;
    connected_ = ::connect(socket_.get(), address, size) == 0;
  }

  bool connected() const { return connected_; }
  /// How long receive() and is_closed() wait for the server.
  void wait_at_most(int milliseconds) { patience_ = milliseconds; }
  int descriptor() const { return socket_.get(); }

  void send(const Bytes& bytes) const {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const ssize_t count = ::send(socket_.get(), bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) return;
      sent += static_cast<std::size_t>(count);
    }
  }

  /// `size` bytes, or fewer if the server closed the connection or did not answer in time.
  Bytes receive(std::size_t size) const {
    Bytes bytes;
    while (bytes.size() < size) {
      pollfd waiting{socket_.get(), POLLIN, 0};
      if (::poll(&waiting, 1, patience_) <= 0) break;
      Bytes part(size - bytes.size());
      const ssize_t count = ::recv(socket_.get(), part.data(), part.size(), 0);
      if (count <= 0) break;
      bytes.insert(bytes.end(), part.begin(), part.begin() + count);
    }
    return bytes;
  }

  /// True if the server has closed the connection; waits for it.
  bool is_closed() const {
    pollfd waiting{socket_.get(), POLLIN, 0};
    if (::poll(&waiting, 1, patience_) <= 0) return false;
    std::uint8_t byte = 0;
    return ::recv(socket_.get(), &byte, 1, 0) <= 0;
  }

  /// The PDU of the answer to one request.
  Bytes ask(const Bytes& pdu) {
    send(frame(++transaction_, pdu));
    const Bytes header = receive(7);
    if (header.size() != 7 || header[1] != (transaction_ & 0xFF)) return {};
    return receive(static_cast<std::size_t>(header[5]) - 1);
  }

  static Bytes frame(int transaction, const Bytes& pdu, int protocol = 0, std::uint8_t unit = 1) {
    Bytes bytes;
    for (const int field : {transaction, protocol, static_cast<int>(pdu.size()) + 1}) {
      bytes.push_back(static_cast<std::uint8_t>(field >> 8));
      bytes.push_back(static_cast<std::uint8_t>(field & 0xFF));
    }
    bytes.push_back(unit);
    for (const std::uint8_t byte : pdu) bytes.push_back(byte);
    return bytes;
  }

 private:
  link::net::Descriptor socket_;
  bool connected_ = false;
  int patience_ = 30'000;
  int transaction_ = 0;
};

}  // namespace symplant::test
