// Servers that close their connection after each answer.
#pragma once

#include <chrono>

#include "symplant/tables/time.hpp"

namespace symplant::link::client {

/// Whether a request that finds its connection closed may be sent again over a new one. It may if the server closed the
/// connection after one answer: such a server does so by design. If the server closed it earlier, the connection
/// failed. If it closed it later, the link's thread must reconnect, which identifies the PLC again. Used by one thread;
/// O(1).
class ShortConnections {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `gap`: the least time from one connection to the next, in ns.
  explicit ShortConnections(tables::Time gap) noexcept : gap_(gap) {}

  void opened() noexcept {
    opened_ = std::chrono::steady_clock::now();
    answers_ = 0;
  }
  void answered() noexcept { ++answers_; }
  bool may_reopen() const noexcept { return answers_ == 1; }
  /// When the next connection may be opened.
  Time next() const noexcept { return opened_ + gap_; }

 private:
  std::chrono::nanoseconds gap_;
  Time opened_ = {};
  unsigned answers_ = 0;  ///< on this connection
};

}  // namespace symplant::link::client
