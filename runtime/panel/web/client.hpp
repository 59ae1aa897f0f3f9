// A client of the panel's web server, as the others see it.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include "symplant/panel/web/content.hpp"

namespace symplant::panel::web {

using Clock = std::chrono::steady_clock;

/// Used by the server's thread only.
class Client {
 public:
  virtual ~Client() = default;
  /// Whether it waits for a request, or for the rest of one.
  virtual bool is_idle() const = 0;
  virtual bool is_stream() const = 0;
  /// Of a stream: whether its client sees malfunctions, and what is for the trainer.
  virtual bool sees_all() const = 0;
  virtual void close() = 0;
  /// Closes it, and what the client has not read is lost.
  virtual void abandon() = 0;
  /// Sends an event after those that are not sent yet. A client that does not read them in time gets a picture instead
  /// of all that it missed.
  virtual void send(const Bytes& event) = 0;
  /// To be called about once a second: abandons a client that has acknowledged nothing of what it is sent for the
  /// server's patience.
  virtual void look(Clock::time_point now) = 0;
  /// The rate at which the client takes its answer, in bytes/s; nothing without an answer, or if it began less than a
  /// second ago.
  virtual std::optional<double> rate(Clock::time_point now) const = 0;
  /// The bytes that the system has not taken yet.
  virtual std::size_t waiting() const = 0;
};

}  // namespace symplant::panel::web
