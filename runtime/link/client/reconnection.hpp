// How long a client link waits before it connects again.
#pragma once

#include <algorithm>

#include "symplant/link/client/parts.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::client {

/// Pauses that double as long as connections fail or end early, so that a PLC that closes every connection is not
/// flooded with new ones. A value; times in ns.
class Reconnection {
 public:
  /// A connection that exchanged for this long did not end early.
  static constexpr tables::Time kEarly = 10 * tables::kSecond;

  explicit Reconnection(const ClientTimes& times) noexcept : times_(times) {}

  /// After an attempt that brought no complete reading: `first_retry`, doubled up to `last_retry`.
  tables::Time after_failure() noexcept {
    const tables::Time pause = std::max(failed_, times_.first_retry);
    failed_ = std::min(2 * pause, std::max(times_.first_retry, times_.last_retry));
    return pause;
  }
  /// After a connection that brought complete readings for `lasted`: none if that was long, else `poll`, doubled up to
  /// `first_retry`.
  tables::Time after_exchange(tables::Time lasted) noexcept {
    failed_ = 0;
    if (lasted >= kEarly) {
      early_ = 0;
      return 0;
    }
    const tables::Time pause = early_;
    early_ = std::min(std::max(2 * early_, times_.poll), std::max(times_.first_retry, times_.poll));
    return pause;
  }

 private:
  ClientTimes times_;
  tables::Time failed_ = 0;  ///< the next pause, if it is longer than the first one
  tables::Time early_ = 0;   ///< the next pause after a connection that ended early; the first one has none
};

}  // namespace symplant::link::client
