// One Modbus request and its reply at a time over a TCP connection.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/client/short_connections.hpp"
#include "symplant/link/modbus/client_codec.hpp"
#include "symplant/link/modbus/client_settings.hpp"
#include "symplant/link/net/client_socket.hpp"

namespace symplant::link::modbus {

/// Sends requests and receives replies. After a fault it must be closed. Used by one thread; interrupt() by any.
class ClientExchange {
 public:
  explicit ClientExchange(const ClientSettings& settings);

  client::Fault open();
  void close() noexcept { socket_.close(); }
  void interrupt() noexcept { socket_.interrupt(); }

  /// Sends the request and waits for its reply, which is valid until the next call. `values`: of a request of kind
  /// write. Frames with other transaction ids are dropped. A reply with an exception is not a fault. A server that
  /// closes its connection after each answer gets the request over a new one.
  client::Fault transact(const ClientRequest& request, std::span<const std::uint16_t> values, ClientReply& reply);

  /// Of the latest request that was answered, by the steady clock in ns: before it was sent, and when its answer was
  /// complete.
  tables::Time sent() const noexcept { return sent_; }
  tables::Time answered() const noexcept { return at_; }

 private:
  client::Fault attempt(const ClientRequest& request, std::span<const std::uint16_t> values, ClientReply& reply);
  client::Fault drop_late();
  client::Fault receive(const ClientRequest& request, ClientReply& reply, net::Deadline end);
  client::Fault failed(net::Ended ended, const char* doing);
  client::Fault unknown(const std::string& reason) const;
  net::Deadline deadline() const;
  void drop(std::size_t count) noexcept;

  net::HostPort address_;
  tables::Time timeout_;
  net::ClientSocket socket_;
  ClientHeader header_;
  client::ShortConnections short_;
  bool closed_ = false;    ///< the latest attempt found the connection closed, without a byte of a reply
  bool answered_ = false;  ///< there was a reply since the first open()
  tables::Time sent_ = 0;
  tables::Time at_ = 0;
  std::vector<std::uint8_t> frame_;
  std::vector<std::uint8_t> received_;
  std::size_t size_ = 0;  ///< bytes in received_
  std::size_t used_ = 0;  ///< bytes of the latest reply, at the beginning of received_
};

}  // namespace symplant::link::modbus
