// The sockets of a Modbus TCP server and the thread that serves them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "symplant/link/modbus/connection.hpp"
#include "symplant/link/net/socket_set.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::modbus {

/// Limits of a server on the number of clients and on their silence.
struct ServerOptions {
  std::size_t connections = 32;               ///< at once; 0 counts as 1
  tables::Time idle = 300 * tables::kSecond;  ///< a client without a request for this long is closed; 0: never
  tables::Time frame =
      10 * tables::kSecond;            ///< a client that does not complete a frame within this time is closed; > 0
  std::vector<std::string> keep = {};  ///< numeric addresses of clients that are never closed for a new one
};

/// Serves clients from its construction to its destruction, in a separate thread that takes no signals.
///
/// When all connections are in use, a new client replaces one that never sent a request, else the one whose latest
/// request is the oldest. If all others are to be kept, the new client is closed. If the process has no descriptor
/// left, one client without a request for 10 s is closed; any other obstacle to a new client closes no existing one.
/// The system's keep-alive detects a vanished peer, or one that acknowledges nothing, after 25 s.
class Server {
 public:
  /// `listener` is non-blocking; `responder` is called by the server's thread only and must outlive it.
  /// Raises the process's soft limit of descriptors by the number of connections, at most to the hard limit. Throws
  /// std::system_error if the system has no descriptor or thread left, or if the hard limit is too small.
  Server(net::Descriptor listener, Responder& responder, ServerOptions options = {});
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  /// While it is cut, all clients are closed, within a second, and no request is answered. Any thread, wait-free.
  void cut(bool on) noexcept { cut_.store(on, std::memory_order_relaxed); }
  /// Number of open connections. Any thread.
  std::uint32_t connections() const noexcept { return open_.load(std::memory_order_relaxed); }
  /// Number of clients closed because there was no room for all, whether new or replaced. Any thread.
  std::uint64_t crowded_out() const noexcept { return crowded_out_.load(std::memory_order_relaxed); }

 private:
  struct Client;

  void serve();
  int milliseconds_to_wait() const noexcept;
  void accept_clients();
  void add_client(net::Descriptor socket);
  void serve_client(Client& client, const net::SocketSet::Ready& ready);
  bool read_from(Client& client);
  void note_progress(Client& client, std::uint64_t requests_before) noexcept;
  bool rearm(Client& client);
  void close_client(int fd);
  void close_all();
  /// Closes the client to be replaced, never one with a request within `quiet`. False if there is no such client.
  bool make_room(tables::Time quiet);
  void close_overdue();
  void listen(bool on);

  net::Descriptor listener_;
  Responder& responder_;
  ServerOptions options_;
  net::SocketSet sockets_;
  net::Wakeup wake_;                                ///< woken once, to end the thread
  std::map<int, std::unique_ptr<Client>> clients_;  ///< by descriptor
  std::uint32_t accepted_ = 0;                      ///< number of clients accepted so far
  std::uint64_t uses_ = 0;                          ///< counts accepts and requests, to find the client used last
  tables::Time now_ = 0;                            ///< steady clock at the latest events
  tables::Time next_sweep_ = 0;                     ///< time of the next search for overdue clients
  bool listening_ = true;
  bool gave_way_ = false;  ///< a client was closed to get a descriptor, and none was accepted since
  std::atomic<bool> cut_{false};
  std::atomic<std::uint32_t> open_{0};
  std::atomic<std::uint64_t> crowded_out_{0};
  std::thread thread_;
};

}  // namespace symplant::link::modbus
