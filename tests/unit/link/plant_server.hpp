// A Modbus server link with a plant behind it that a test cycles by hand, and a client of raw bytes.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "symplant/link/link.hpp"
#include "symplant/link/modbus/socket.hpp"
#include "unit/exec/cell.hpp"

namespace symplant::test {

using Bytes = std::vector<std::uint8_t>;

inline std::unique_ptr<link::Link> open_or_throw(const std::string& url, const core::PlantTables& tables) {
  auto result = link::open_link({url}, tables);
  if (auto* error = std::get_if<link::LinkError>(&result)) throw std::runtime_error(error->message);
  return std::move(std::get<std::unique_ptr<link::Link>>(result));
}

inline std::uint16_t port_of(const link::Link& link) {
  const std::string url = link.url();
  return static_cast<std::uint16_t>(std::stoi(url.substr(url.rfind(':') + 1)));
}

/// The paper's cell, served. Plant time is what the test says.
class CellServer {
 public:
  CellServer()
      : tables_(cell_tables()), plant_(tables_), link_(open_or_throw("modbus-tcp-server://127.0.0.1:0", tables_)) {
    plant_->advance_to(0);
    link_->write_events(*plant_, {});
    plant_->forget_changed_events();
  }
  ~CellServer() { stop_cycling(); }
  CellServer(const CellServer&) = delete;
  CellServer& operator=(const CellServer&) = delete;

  void cycle(core::Time duration) {
    link_->read_operations(*plant_, 0);
    plant_->advance_to(plant_->now() + duration);
    link_->write_events(*plant_, {});
    plant_->forget_changed_events();
  }

  /// Cycles as fast as it can in a thread of its own; plant time runs much faster than real time.
  void start_cycling() {
    cycling_ = std::thread([this] {
      while (!stop_) {
        cycle(core::kMillisecond);
        std::this_thread::yield();
      }
    });
  }
  void stop_cycling() {
    stop_ = true;
    if (cycling_.joinable()) cycling_.join();
  }

  core::Plant& plant() { return *plant_; }
  link::Link& link() { return *link_; }
  std::uint16_t port() const { return port_of(*link_); }

 private:
  core::PlantTables tables_;
  OwnedPlant plant_;
  std::unique_ptr<link::Link> link_;
  std::atomic<bool> stop_{false};
  std::thread cycling_;
};

/// A TCP client on the loopback that waits for what it reads; the wait has an end only so that a failed test has one.
class RawClient {
 public:
  explicit RawClient(std::uint16_t port, int family = AF_INET)
      : socket_(::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const int on = 1;
    ::setsockopt(socket_.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
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
  int descriptor() const { return socket_.get(); }

  void send(const Bytes& bytes) const {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const ssize_t count = ::send(socket_.get(), bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) return;
      sent += static_cast<std::size_t>(count);
    }
  }

  /// `size` bytes, or fewer where the server closed the connection (or did not answer for half a minute).
  Bytes receive(std::size_t size) const {
    Bytes bytes;
    while (bytes.size() < size) {
      pollfd waiting{socket_.get(), POLLIN, 0};
      if (::poll(&waiting, 1, 30'000) <= 0) break;
      Bytes part(size - bytes.size());
      const ssize_t count = ::recv(socket_.get(), part.data(), part.size(), 0);
      if (count <= 0) break;
      bytes.insert(bytes.end(), part.begin(), part.begin() + count);
    }
    return bytes;
  }

  /// True when the server has closed the connection; waits for it.
  bool is_closed() const {
    pollfd waiting{socket_.get(), POLLIN, 0};
    if (::poll(&waiting, 1, 30'000) <= 0) return false;
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

  static Bytes frame(int transaction, const Bytes& pdu, int protocol = 0) {
    Bytes bytes;
    for (const int field : {transaction, protocol, static_cast<int>(pdu.size()) + 1}) {
      bytes.push_back(static_cast<std::uint8_t>(field >> 8));
      bytes.push_back(static_cast<std::uint8_t>(field & 0xFF));
    }
    bytes.push_back(1);
    for (const std::uint8_t byte : pdu) bytes.push_back(byte);
    return bytes;
  }

 private:
  link::modbus::Descriptor socket_;
  bool connected_ = false;
  int transaction_ = 0;
};

}  // namespace symplant::test
