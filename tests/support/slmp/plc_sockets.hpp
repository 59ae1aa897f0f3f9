// The sockets of a PLC: one thread that serves TCP connections and UDP peers on the loopback.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "support/slmp/plc_frames.hpp"

namespace symplant::test::slmp {

/// How the reply to one request leaves: the parts in order, then perhaps the end of the connection.
struct Delivery {
  struct Part {
    Bytes bytes;
    std::chrono::milliseconds after{0};  ///< since the part before it
  };
  std::vector<Part> parts;                               ///< over UDP a datagram each
  bool resets = false;                                   ///< the connection, after the parts; nothing over UDP
  std::optional<std::chrono::milliseconds> refuses_for;  ///< connection attempts, from now on
};

/// A connection, or the address that datagrams come from. Ids are not used again.
struct Peer {
  std::size_t id = 0;
  bool is_udp = false;
  bool awaits_reply = false;  ///< parts of earlier replies are not due yet
};

/// What was received from a peer, and what the server does with it. Called on the server's thread.
class PeerHandler {
 public:
  virtual ~PeerHandler() = default;
  /// `bytes`: of UDP one datagram; of TCP everything received and not yet used. Returns how many bytes are used up,
  /// and adds the replies to `out`.
  virtual std::size_t received(const Peer& peer, std::span<const std::uint8_t> bytes, std::vector<Delivery>& out) = 0;
  virtual void accepted(const Peer& peer) = 0;
  virtual void refused_connection() = 0;
  virtual void closed(const Peer& peer) = 0;
};

struct SocketOptions {
  bool tcp = true;
  bool udp = true;
  std::uint16_t port = 0;  ///< 0: any that is free, the same for TCP and UDP
  std::size_t most_connections = 1;
};

class PlcSockets {
 public:
  /// The handler must live as long. Throws std::runtime_error if the port is taken.
  PlcSockets(const SocketOptions& options, PeerHandler& handler);
  ~PlcSockets();
  PlcSockets(const PlcSockets&) = delete;
  PlcSockets& operator=(const PlcSockets&) = delete;

  std::uint16_t port() const;
  std::size_t connections() const;
  /// Ends every connection, with a FIN or a reset. Has done so on return. Not from the server's thread.
  void close_connections(bool with_reset);
  /// While on, the port does not listen. Has taken effect on return. Not from the server's thread.
  void refuse_connections(bool on);

 private:
  class Loop;
  std::unique_ptr<Loop> loop_;
};

}  // namespace symplant::test::slmp
