// Requests built field by field, and a client of raw frames.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <string_view>
#include <vector>

#include "support/slmp/plc_commands.hpp"
#include "support/slmp/plc_fields.hpp"
#include "support/slmp/plc_loop.hpp"

namespace symplant::test::slmp {

/// Builds one request.
class Request {
 public:
  Request(std::uint16_t command, std::uint16_t subcommand, Code code = Code::binary) : payload_(code), code_(code) {
    frame_.command = command;
    frame_.subcommand = subcommand;
    frame_.timer = 0x10;
  }

  Request& device(std::string_view name, std::uint32_t number) {
    const DeviceType& type = *device_of_name(name);
    const bool is_iqr = (frame_.subcommand & 2U) != 0;
    if (code_ == Code::binary) {
      payload_.number(number, is_iqr ? 4 : 3);
      payload_.number(type.code, is_iqr ? 2 : 1);
      return *this;
    }
    std::string text = is_iqr ? std::string(type.name) : std::string(type.ql_name);
    text.resize(is_iqr ? 4 : 2, '*');
    payload_.text(text);
    const std::string digits = address_text(type, number, Family::q).substr(type.name.size());
    payload_.text(std::string((is_iqr ? 8 : 6) - digits.size(), '0') + digits);
    return *this;
  }
  Request& number(std::uint32_t value, std::size_t bytes) {
    payload_.number(value, bytes);
    return *this;
  }
  Request& bits(const std::vector<std::uint32_t>& values) {
    payload_.bits(values);
    return *this;
  }
  Request& words(const std::vector<std::uint32_t>& values) {
    payload_.words(values);
    return *this;
  }
  Request& text(std::string_view characters) {
    payload_.text(characters);
    return *this;
  }
  Request& serial(std::uint16_t value) {
    frame_.is_4e = true;
    frame_.serial = value;
    return *this;
  }

  RequestFrame frame() const {
    RequestFrame whole = frame_;
    whole.payload = payload_.bytes();
    return whole;
  }

  /// The bytes on the wire.
  Bytes bytes() const {
    FieldWriter wire(code_);
    wire.subheader(frame_.is_4e ? 0x5400 : 0x5000);
    if (frame_.is_4e) wire.number(frame_.serial, 2);
    if (frame_.is_4e) wire.number(0, 2);
    wire.number(0, 1);
    wire.number(0xFF, 1);
    wire.number(0x03FF, 2);
    wire.number(0, 1);
    const std::size_t fixed = code_ == Code::ascii ? 12 : 6;
    wire.number(static_cast<std::uint32_t>(payload_.bytes().size() + fixed), 2);
    for (const std::uint32_t field : {std::uint32_t{0x10}, std::uint32_t{frame_.command}}) wire.number(field, 2);
    wire.number(frame_.subcommand, 2);
    wire.raw(payload_.bytes());
    return wire.bytes();
  }

 private:
  FieldWriter payload_;
  Code code_;
  RequestFrame frame_;
};

/// Sends and receives raw bytes on the loopback. A time limit only lets a failed test end.
class WireClient {
 public:
  explicit WireClient(std::uint16_t port, bool is_udp = false)
      : socket_(::socket(AF_INET, is_udp ? SOCK_DGRAM : SOCK_STREAM, 0)) {
    const int on = 1;
    if (!is_udp) ::setsockopt(socket_.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }

  bool connected() const { return connected_; }

  void send(const Bytes& bytes) const {
    [[maybe_unused]] const ssize_t count = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  /// `size` bytes, or fewer if the server closed the connection or did not reply.
  Bytes receive(std::size_t size) const {
    Bytes all;
    while (all.size() < size) {
      const Bytes part = receive_some(size - all.size());
      if (part.empty()) break;
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }

  /// What one call to recv gives: of UDP a datagram. Empty: closed, reset, or no reply.
  Bytes receive_some(std::size_t most = 65'536) const {
    pollfd waiting{socket_.get(), POLLIN, 0};
    if (::poll(&waiting, 1, 30'000) <= 0) return {};
    Bytes bytes(most);
    const ssize_t count = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }

  bool is_closed() const { return receive_some(1).empty(); }

 private:
  FileDescriptor socket_;
  bool connected_ = false;
};

}  // namespace symplant::test::slmp
