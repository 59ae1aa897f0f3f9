// Many sockets that one thread waits for.
#pragma once

#include <memory>
#include <span>

#include "symplant/link/net/socket.hpp"

namespace symplant::link::net {

/// Not thread-safe. A change costs O(1); a wait costs O(ready sockets) on Linux, O(sockets) on Windows.
class SocketSet {
 public:
  struct Ready {
    int socket = -1;
    bool read = false;   ///< can be read from; also if the peer is gone
    bool write = false;  ///< can be written to
  };

  /// Throws std::system_error if the system has no descriptor left.
  SocketSet();
  ~SocketSet();
  SocketSet(const SocketSet&) = delete;
  SocketSet& operator=(const SocketSet&) = delete;

  /// Return false on failure.
  bool add(int socket, Wanted wanted) noexcept;
  bool change(int socket, Wanted wanted) noexcept;
  /// Call before the socket is closed.
  void remove(int socket) noexcept;

  /// Waits for `milliseconds`, below 0 without an end. The result is valid until the next call.
  std::span<const Ready> wait(int milliseconds) noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace symplant::link::net
