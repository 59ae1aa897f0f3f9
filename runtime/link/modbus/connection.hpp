// One client of the server: its bytes in, its answers out, whatever the pace of either.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "symplant/link/modbus/framing.hpp"

namespace symplant::link::modbus {

/// Answers the PDU of a request; the server's tables stand behind it.
class Responder {
 public:
  virtual Answer respond(std::span<const std::uint8_t> request, std::span<std::uint8_t, kMaxPdu> reply) noexcept = 0;
  /// A request was refused without being looked at.
  virtual void refused() noexcept = 0;

 protected:
  ~Responder() = default;
};

/// Where answers go: takes what it can without waiting. Returns the bytes taken, less than 0 where the peer is gone.
class Sink {
 public:
  virtual std::ptrdiff_t write(std::span<const std::uint8_t> bytes) noexcept = 0;

 protected:
  ~Sink() = default;
};

/// The protocol's state of one connection, apart from its socket.
///
/// Requests are answered in their order, as they come: split anywhere or many at once. At most kMaxInFlight answers
/// wait for the peer to take them; requests beyond that are refused with exception 06, and when kMaxQueued answers
/// wait, the connection takes no further bytes until some have gone.
class Connection {
 public:
  static constexpr std::size_t kMaxInFlight = 16;
  static constexpr std::size_t kMaxQueued = 64;

  enum class State { open, closed };

  /// Where received bytes are to be put; empty while no more are taken.
  std::span<std::uint8_t> room() noexcept;
  /// Takes `count` bytes put into room(), answers what is complete and sends what the peer takes.
  State received(std::size_t count, Responder& responder, Sink& sink);
  /// Sends on, after the peer was found ready; then answers what had to wait.
  State resume(Responder& responder, Sink& sink);

  bool has_answers_to_send() const noexcept { return sent_ < out_.size(); }
  /// Bytes are there that no whole frame is made of yet, or that wait until answers have gone.
  bool holds_part_of_frame() const noexcept { return in_size_ != 0; }
  std::uint64_t requests() const noexcept { return requests_; }

 private:
  State work(Responder& responder, Sink& sink);
  void answer(const Frame& frame, Responder& responder);
  bool flush(Sink& sink);

  static constexpr std::size_t kRoom = 16 * kMaxFrame;

  std::array<std::uint8_t, kRoom> in_{};
  std::size_t in_size_ = 0;
  std::vector<std::uint8_t> out_;
  std::size_t sent_ = 0;            ///< bytes of out_ that the peer took
  std::deque<std::size_t> queued_;  ///< an answer not yet wholly taken: where it ends in out_
  std::uint64_t requests_ = 0;
};

}  // namespace symplant::link::modbus
