// One Modbus request and its reply at a time over a TCP connection.
#include "symplant/link/modbus/client_exchange.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "symplant/link/client/bytes_text.hpp"
#include "symplant/link/client/steady_now.hpp"

namespace symplant::link::modbus {

namespace {

constexpr const char* kUnasked = "the PLC sent more than was requested; connecting again";

client::Fault broken_off(std::string message) { return {client::Fault::Kind::transport, std::move(message)}; }

}  // namespace

ClientExchange::ClientExchange(const ClientSettings& settings)
    : address_(settings.address),
      timeout_(settings.timeout),
      header_{.transaction = 0, .unit = settings.unit},
      short_(settings.times.poll),
      frame_(kMaxFrame),
      received_(4 * kMaxFrame) {}

net::Deadline ClientExchange::deadline() const {
  return std::chrono::steady_clock::now() + std::chrono::nanoseconds(timeout_);
}

client::Fault ClientExchange::open() {
  size_ = 0;
  used_ = 0;
  const net::Ended ended = socket_.connect(address_, net::Transport::tcp, deadline());
  if (ended == net::Ended::done) {
    short_.opened();
    return {};
  }
  if (ended == net::Ended::interrupted) return {client::Fault::Kind::interrupted};
  const std::string reason = ended == net::Ended::timeout ? "no answer" : socket_.fault();
  return broken_off("no connection to " + net::format_host_port(address_) + ": " + reason +
                    "; check the address, the cable, and that the PLC's Modbus server is switched on");
}

client::Fault ClientExchange::failed(net::Ended ended, const char* doing) {
  if (ended == net::Ended::interrupted) return {client::Fault::Kind::interrupted};
  if (ended == net::Ended::closed) {
    closed_ = size_ == 0;
    return broken_off(std::string("connection lost ") + doing + ": " + socket_.fault());
  }
  if (size_ != 0 && !answered_) return unknown("it is cut");
  return broken_off(
      "the PLC is connected but does not answer; connecting again (if this persists, check `unit` and raise "
      "`timeout`)");
}

client::Fault ClientExchange::unknown(const std::string& reason) const {
  if (answered_) return broken_off("the PLC's answer is invalid, " + reason + "; connecting again");
  return broken_off("connected, but the answer is not from a Modbus server, " +
                    client::bytes_text(std::span(received_).first(size_)) + " (" + reason +
                    "): check the address and the port");
}

void ClientExchange::drop(std::size_t count) noexcept {
  std::copy(received_.begin() + static_cast<std::ptrdiff_t>(count),
            received_.begin() + static_cast<std::ptrdiff_t>(size_), received_.begin());
  size_ -= count;
}

/// What arrived before a request is sent cannot be its reply, whatever its transaction id is.
client::Fault ClientExchange::drop_late() {
  constexpr int kMostReads = 16;  // a PLC that never stops sending has no reply to wait for
  drop(std::exchange(used_, 0));
  for (int reads = 0; reads < kMostReads; ++reads) {
    for (Frame frame = parse_frame(std::span(received_).first(size_)); frame.kind != Frame::Kind::incomplete;
         frame = parse_frame(std::span(received_).first(size_))) {
      if (frame.kind == Frame::Kind::broken) return broken_off(kUnasked);
      drop(frame.consumed);
    }
    std::size_t count = 0;
    const net::Ended ended = socket_.receive(std::span(received_).subspan(size_), count, net::Deadline());
    if (ended == net::Ended::timeout && size_ == 0) return {};
    if (ended == net::Ended::timeout) break;
    if (ended != net::Ended::done) return failed(ended, "before a request");
    size_ += count;
  }
  return broken_off(kUnasked);
}

client::Fault ClientExchange::transact(const ClientRequest& request, std::span<const std::uint16_t> values,
                                       ClientReply& reply) {
  client::Fault fault = attempt(request, values, reply);
  if (!fault || !std::exchange(closed_, false) || !short_.may_reopen()) return fault;
  if (socket_.wait(short_.next()) == net::Ended::interrupted) return {client::Fault::Kind::interrupted};
  fault = open();
  return fault ? fault : attempt(request, values, reply);
}

client::Fault ClientExchange::attempt(const ClientRequest& request, std::span<const std::uint16_t> values,
                                      ClientReply& reply) {
  closed_ = false;
  if (client::Fault fault = drop_late()) return fault;
  ++header_.transaction;
  const FrameBuffer frame(frame_.data(), kMaxFrame);
  const std::size_t size = request.kind == ClientRequest::Kind::write ? encode_write(header_, request, values, frame)
                                                                      : encode_request(header_, request, frame);
  const net::Deadline end = deadline();
  sent_ = client::steady_now();
  const net::Ended sent = socket_.send(frame.first(size), end);
  return sent == net::Ended::done ? receive(request, reply, end) : failed(sent, "while sending");
}

client::Fault ClientExchange::receive(const ClientRequest& request, ClientReply& reply, net::Deadline end) {
  for (;;) {
    reply = parse_client_reply(std::span(received_).first(size_), header_, request);
    if (reply.kind == ClientReply::Kind::broken) {
      return unknown(reply.reason);
    }
    if (reply.kind == ClientReply::Kind::complete) {
      at_ = client::steady_now();
      used_ = reply.consumed;
      answered_ = true;
      short_.answered();
      return {};
    }
    if (reply.kind == ClientReply::Kind::foreign) {
      drop(reply.consumed);
      // A PLC that keeps sending other frames must not hold the link for longer than the timeout.
      if (std::chrono::steady_clock::now() >= end) return failed(net::Ended::timeout, "");
      continue;
    }
    std::size_t count = 0;
    const net::Ended ended = socket_.receive(std::span(received_).subspan(size_), count, end);
    if (ended != net::Ended::done) return failed(ended, "while waiting for an answer");
    size_ += count;
  }
}

}  // namespace symplant::link::modbus
