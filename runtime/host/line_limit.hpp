// Limits how often lines about one subject are shown, without losing their number.
#pragma once

#include <chrono>
#include <cstdint>
#include <utility>

namespace symplant::host {

/// Lines about one subject: in ten seconds from the first one five are shown, the others are counted. Any clock; used
/// by one thread at a time.
class LineLimit {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kWindow{10};
  static constexpr std::uint64_t kMost = 5;

  /// Whether a line is shown now; otherwise it is counted. Call take_hidden() first.
  bool admits(Clock::time_point now) noexcept {
    if (is_over(now)) {
      begin_ = now;
      shown_ = 0;
    }
    if (shown_ == kMost) {
      ++hidden_;
      return false;
    }
    ++shown_;
    return true;
  }

  /// How many lines were not shown, once the ten seconds are over, or at once if `at_end`; they are counted only once.
  std::uint64_t take_hidden(Clock::time_point now, bool at_end) noexcept {
    return at_end || is_over(now) ? std::exchange(hidden_, 0) : 0;
  }

 private:
  bool is_over(Clock::time_point now) const noexcept { return shown_ == 0 || now - begin_ >= kWindow; }

  Clock::time_point begin_;
  std::uint64_t shown_ = 0;
  std::uint64_t hidden_ = 0;
};

}  // namespace symplant::host
