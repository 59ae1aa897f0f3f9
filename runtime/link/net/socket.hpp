// A socket with one owner, and the calls of the system on sockets that differ between systems.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace symplant::link::net {

using Deadline = std::chrono::steady_clock::time_point;

/// Call before names are resolved; open_socket() does it, too.
void start_sockets() noexcept;
void close_socket(int socket) noexcept;

/// A socket, or another descriptor that can be waited for. Closes what it holds; -1 holds nothing.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int fd) noexcept : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) close_socket(fd_);
  }

  int get() const noexcept { return fd_; }
  int release() noexcept { return std::exchange(fd_, -1); }
  explicit operator bool() const noexcept { return fd_ >= 0; }

 private:
  int fd_ = -1;
};

/// The errno of the calling thread's latest call that failed, on each system by the names of POSIX.
int last_error() noexcept;
/// "connection refused"
std::string error_text(int error);
/// Whether the call would have to wait.
bool would_wait(int error) noexcept;
/// Whether connect() has begun, and goes on.
bool is_connecting(int error) noexcept;

/// Sockets that do not block, and that no child process inherits; nothing, with last_error(), on failure.
Descriptor open_socket(int family, int type) noexcept;
Descriptor accept_client(int listener) noexcept;
/// Before bind(): a port that no other program listens on can be used at once, though connections of an earlier run
/// still close (Windows may need some minutes for them). No other program can listen on it, too.
void take_port_soon(int socket) noexcept;
/// Whether the error of bind() may mean that another program has the port.
bool is_taken(int error) noexcept;
/// What to do if the system does not permit a port.
std::string how_to_get_port(std::uint16_t port);
/// The pending error of a socket; 0: none.
int pending_error(int socket) noexcept;

/// Without waiting. Return the number of bytes; -1 with last_error(). A datagram is cut to the room; a peer that is
/// gone raises no signal.
std::ptrdiff_t receive(int socket, std::span<std::uint8_t> room) noexcept;
std::ptrdiff_t send(int socket, std::span<const std::uint8_t> bytes) noexcept;

/// Wakes a thread that waits for sockets.
class Wakeup {
 public:
  /// Throws std::system_error if the system has no descriptor left.
  Wakeup();
  /// Makes socket() readable, for ever. Any thread.
  void wake() noexcept;
  int socket() const noexcept { return read_.get(); }

 private:
  Descriptor read_;
};

struct Wanted {
  bool read = false;
  bool write = false;
  bool operator==(const Wanted&) const = default;
};

/// Waits until `socket` can do what is wanted (or failed), `wakeup` is readable, or the deadline. Two results, both
/// false at the deadline.
struct Readiness {
  bool woken = false;
  bool ready = false;
};
Readiness wait_for(int wakeup, int socket, Wanted wanted, Deadline deadline) noexcept;

}  // namespace symplant::link::net
