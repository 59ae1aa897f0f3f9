// One client of the server: reads its requests and sends its answers, each at its own pace.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "symplant/link/modbus/framing.hpp"
#include "symplant/link/modbus/operation_writes.hpp"

namespace symplant::link::modbus {

/// Answers the PDU of a request from the server's tables.
class Responder {
 public:
  virtual Answer respond(const ClientId& client, std::span<const std::uint8_t> request,
                         std::span<std::uint8_t, kMaxPdu> reply) noexcept = 0;
  /// A request was rejected with exception 06, without being parsed.
  virtual void refused(std::span<const std::uint8_t> request) noexcept = 0;
  /// A client's connection is closed.
  virtual void left(const ClientId& /*client*/) noexcept {}

 protected:
  ~Responder() = default;
};

/// The receiver of answers: takes what it can without waiting. Returns the bytes taken; less than 0 if the peer is
/// gone.
class Sink {
 public:
  virtual std::ptrdiff_t write(std::span<const std::uint8_t> bytes) noexcept = 0;

 protected:
  ~Sink() = default;
};

/// The protocol state of one connection, without its socket. Not thread-safe.
///
/// Requests are answered in their order, whether they arrive in pieces or many at once. At most kMaxInFlight answers
/// wait for the peer to take them; further requests are rejected with exception 06. When kMaxQueued answers wait, the
/// connection takes no further bytes until some have been sent.
class Connection {
 public:
  static constexpr std::size_t kMaxInFlight = 16;
  static constexpr std::size_t kMaxQueued = 64;

  enum class State { open, closed };

  explicit Connection(const ClientId& client = {}) noexcept : client_(client) {}

  /// Buffer for received bytes; empty while the connection takes no more.
  std::span<std::uint8_t> room() noexcept;
  /// Takes `count` bytes put into room(), answers complete requests and sends what the peer takes.
  State received(std::size_t count, Responder& responder, Sink& sink);
  /// Continues to send when the peer is ready; then answers the requests that had to wait.
  State resume(Responder& responder, Sink& sink);

  bool has_answers_to_send() const noexcept { return sent_ < out_.size(); }
  /// Whether received bytes wait: for the rest of their frame, or until answers have been sent.
  bool holds_part_of_frame() const noexcept { return in_size_ != 0; }
  std::uint64_t requests() const noexcept { return requests_; }
  const ClientId& client() const noexcept { return client_; }

 private:
  State work(Responder& responder, Sink& sink);
  void answer(const Frame& frame, Responder& responder);
  bool flush(Sink& sink);

  static constexpr std::size_t kRoom = 16 * kMaxFrame;

  ClientId client_;
  std::array<std::uint8_t, kRoom> in_{};
  std::size_t in_size_ = 0;
  std::vector<std::uint8_t> out_;
  std::size_t sent_ = 0;            ///< number of bytes of out_ that the peer took
  std::deque<std::size_t> queued_;  ///< for each answer not yet taken completely: its end in out_
  std::uint64_t requests_ = 0;
};

}  // namespace symplant::link::modbus
