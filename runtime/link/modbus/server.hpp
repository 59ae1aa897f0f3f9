// The sockets of a Modbus TCP server and the thread that serves them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <thread>

#include "symplant/link/modbus/connection.hpp"
#include "symplant/link/modbus/socket.hpp"

namespace symplant::link::modbus {

/// Serves clients from its construction to its destruction, in a thread of its own that takes no signals.
///
/// When all connections are taken, a new client gets the place of the one whose latest request is the oldest.
class Server {
 public:
  static constexpr std::size_t kMaxConnections = 32;

  /// `listener` is non-blocking; `responder` is called by the server's thread only and must outlive it.
  /// Throws std::system_error where the system has no descriptor or thread left.
  Server(Descriptor listener, Responder& responder, std::size_t max_connections = kMaxConnections);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  /// Open now. Any thread.
  std::uint32_t connections() const noexcept { return open_.load(std::memory_order_relaxed); }

 private:
  struct Client;

  void serve();
  void accept_clients();
  void add_client(Descriptor socket);
  void serve_client(Client& client, std::uint32_t events);
  bool read_from(Client& client);
  bool rearm(Client& client);
  void close_client(int fd);
  bool close_oldest();
  void listen(bool on);

  Descriptor listener_;
  Responder& responder_;
  std::size_t max_connections_;
  Descriptor epoll_;
  Descriptor wake_;                                 ///< an eventfd: written once, to end the thread
  std::map<int, std::unique_ptr<Client>> clients_;  ///< by descriptor
  std::uint64_t uses_ = 0;                          ///< counts accepts and requests, to tell who was used last
  bool listening_ = true;
  std::atomic<std::uint32_t> open_{0};
  std::thread thread_;
};

}  // namespace symplant::link::modbus
