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
#include "symplant/link/modbus/socket.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::modbus {

/// How many clients a server has, and for how long.
struct ServerOptions {
  std::size_t connections = 32;               ///< at once; 0 counts as 1
  tables::Time idle = 300 * tables::kSecond;  ///< a client without a request for so long is closed; 0: never
  tables::Time frame =
      10 * tables::kSecond;            ///< a frame that was begun is whole within it, or its client is closed; > 0
  std::vector<std::string> keep = {};  ///< numeric addresses of clients that never give way to a new one
};

/// Serves clients from its construction to its destruction, in a thread of its own that takes no signals.
///
/// When all connections are taken, a new client gets the place of one that never sent a request, else of the one whose
/// latest request is the oldest; where all others are to be kept, the new one is closed. Where the process has no
/// descriptor left, one client that asked nothing for 10 s gives way; whatever else keeps a new client out, none that
/// is there is closed for it. A peer that vanished without a word is found by the system's keep-alive after 25 s, and
/// so is one that acknowledges nothing of what is sent to it.
class Server {
 public:
  /// `listener` is non-blocking; `responder` is called by the server's thread only and must outlive it.
  /// Raises the process's soft limit of descriptors by the number of connections, at most to the hard one. Throws
  /// std::system_error where the system has no descriptor or thread left, or the hard limit has no room for them.
  Server(Descriptor listener, Responder& responder, ServerOptions options = {});
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  /// Open now. Any thread.
  std::uint32_t connections() const noexcept { return open_.load(std::memory_order_relaxed); }
  /// Clients that were closed since there was no room for all, new ones and such as gave way. Any thread.
  std::uint64_t crowded_out() const noexcept { return crowded_out_.load(std::memory_order_relaxed); }

 private:
  struct Client;

  void serve();
  int milliseconds_to_wait() const noexcept;
  void accept_clients();
  void add_client(Descriptor socket);
  void serve_client(Client& client, std::uint32_t events);
  bool read_from(Client& client);
  void note_progress(Client& client, std::uint64_t requests_before) noexcept;
  bool rearm(Client& client);
  void close_client(int fd);
  /// Closes who gives way; none that asked within `quiet`. False where there is none.
  bool make_room(tables::Time quiet);
  void close_overdue();
  void listen(bool on);

  Descriptor listener_;
  Responder& responder_;
  ServerOptions options_;
  Descriptor epoll_;
  Descriptor wake_;                                 ///< an eventfd: written once, to end the thread
  std::map<int, std::unique_ptr<Client>> clients_;  ///< by descriptor
  std::uint64_t uses_ = 0;                          ///< counts accepts and requests, to tell who was used last
  tables::Time now_ = 0;                            ///< of the steady clock, as the latest events came
  tables::Time next_sweep_ = 0;                     ///< when clients are looked at next for what is overdue
  bool listening_ = true;
  bool gave_way_ = false;  ///< a client was closed for want of descriptors, and no other was accepted since
  std::atomic<std::uint32_t> open_{0};
  std::atomic<std::uint64_t> crowded_out_{0};
  std::thread thread_;
};

}  // namespace symplant::link::modbus
