// The loop of the server's thread. Only for plc_sockets.cpp.
#pragma once

#include <netinet/in.h>
#include <poll.h>

#include <atomic>
#include <deque>
#include <map>
#include <mutex>
#include <thread>

#include "support/slmp/plc_sockets.hpp"

namespace symplant::test::slmp {

class FileDescriptor {
 public:
  explicit FileDescriptor(int number = -1) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  ~FileDescriptor();
  int get() const { return number_; }

 private:
  int number_;
};

class PlcSockets::Loop {
 public:
  Loop(const SocketOptions& options, PeerHandler& handler);
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  std::uint16_t port() const { return port_; }
  std::size_t connections() const { return connection_count_; }
  /// Runs the function on the server's thread and waits for it.
  void run_inside(const std::function<void()>& function);
  void close_all(bool with_reset);
  void set_refusing(bool on);

 private:
  using Clock = std::chrono::steady_clock;

  struct Pending {
    Clock::time_point due;
    Bytes bytes;
    bool resets = false;
  };
  /// A connection, or a UDP peer.
  struct Contact {
    Peer peer;
    FileDescriptor socket;  ///< of a connection
    sockaddr_in address{};  ///< of a UDP peer
    Bytes received;
    std::deque<Pending> pending;
    bool is_closed = false;
  };

  void open_ports();
  bool open_both_on(std::uint16_t port);
  void listen_again();
  void run();
  int next_timeout() const;
  void run_commands();
  void accept_connection();
  void read_connections();
  void read_connection(Contact& contact);
  void read_datagrams();
  Contact& contact_of(const sockaddr_in& address);
  void use(Contact& contact, std::span<const std::uint8_t> bytes, std::size_t* used);
  void queue(Contact& contact, Delivery delivery);
  void send_due();
  void send_now(Contact& contact, const Bytes& bytes);
  void end(Contact& contact, bool with_reset);
  void remove_closed();

  SocketOptions options_;
  PeerHandler& handler_;
  std::uint16_t port_ = 0;
  FileDescriptor listener_;
  FileDescriptor reserved_;  ///< bound, never listening: keeps the port while the listener is closed
  FileDescriptor datagrams_;
  FileDescriptor wake_read_;
  FileDescriptor wake_write_;
  std::map<std::size_t, Contact> contacts_;
  std::size_t next_id_ = 1;
  std::optional<Clock::time_point> refuses_until_;
  std::atomic<std::size_t> connection_count_{0};
  std::atomic<bool> stops_{false};
  std::mutex commands_mutex_;
  std::vector<std::function<void()>> commands_;
  std::thread thread_;
};

}  // namespace symplant::test::slmp
