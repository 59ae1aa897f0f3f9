// One request and its reply at a time over a connection to a PLC.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/client/short_connections.hpp"
#include "symplant/link/net/client_socket.hpp"
#include "symplant/link/slmp/framing.hpp"
#include "symplant/link/slmp/settings.hpp"

namespace symplant::link::slmp {

/// Sends requests and receives replies. After a fault of the transport it is closed: with 3E a late reply cannot be
/// distinguished from the next one. Used by one thread; interrupt() by any.
class Exchange {
 public:
  explicit Exchange(const Settings& settings);

  client::Fault open();
  void close() noexcept;
  void interrupt() noexcept { socket_.interrupt(); }

  /// Starts the next request.
  RequestWriter& begin(Command command, bool bits);
  /// Sends the request and waits for its reply. `reply` is valid until the next call. A reply with an end code is not a
  /// fault. A server that closes its connection after each answer gets the request over a new one.
  client::Fault transact(Reply& reply);

  /// Of the latest request that was answered, by the steady clock in ns: before it was sent, and when its answer was
  /// complete.
  tables::Time sent() const noexcept { return sent_; }
  tables::Time answered() const noexcept { return at_; }

 private:
  client::Fault attempt(Reply& reply);
  client::Fault receive(Reply& reply, net::Deadline deadline);
  client::Fault failed(net::Ended ended, const char* doing);
  client::Fault unknown(const std::string& reason) const;
  net::Deadline deadline() const;

  net::HostPort address_;
  net::Transport transport_;
  Framing framing_;
  tables::Time timeout_;
  net::ClientSocket socket_;
  RequestWriter writer_;
  std::uint16_t serial_ = 0;
  client::ShortConnections short_;
  bool closed_ = false;    ///< the latest attempt found the connection closed, without a byte of a reply
  bool answered_ = false;  ///< there was a reply since the first open()
  tables::Time sent_ = 0;
  tables::Time at_ = 0;
  std::vector<std::uint8_t> received_;
  std::size_t size_ = 0;  ///< bytes in received_
  std::size_t used_ = 0;  ///< bytes of the latest reply, at the beginning of received_
};

}  // namespace symplant::link::slmp
