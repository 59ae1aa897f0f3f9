// When a request that the PLC refused is sent again.
#pragma once

#include <algorithm>
#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::link::client {

/// How the PLC answered a request.
enum class Answer : std::uint8_t {
  accepted,
  busy,       ///< the PLC may accept the same request soon: it is sent again at the next poll
  refused,    ///< it is sent again after a pause that grows with each refusal in a row
  over_gaps,  ///< only of a reading: the PLC lacks addresses between the symbols (gaps); read without gaps
};

/// The refusals of one request in a row. Times are of the thread that sends it, in ns. A value; O(1).
class Retry {
 public:
  static constexpr unsigned kLasting = 8;  ///< refusals in a row, over 3 s, that count as permanent
  static constexpr tables::Time kFirstPause = 50 * tables::kMillisecond;
  static constexpr tables::Time kLongestPause = 30 * tables::kSecond;

  /// The state of a part of a refused request: it counts as refused until the PLC has accepted it once.
  static Retry suspect() noexcept {
    Retry retry;
    retry.refusals_ = 1;
    retry.tried_ = false;
    return retry;
  }

  bool is_due(tables::Time now) const noexcept { return now >= next_; }
  bool is_refused() const noexcept { return refusals_ != 0; }
  /// Whether the PLC has answered it.
  bool is_tried() const noexcept { return tried_; }
  unsigned refusals() const noexcept { return refusals_; }

  void accept() noexcept { *this = {}; }
  /// `answer`: busy or refused. After the first refusal the request is due at the next poll, after the second one in
  /// kFirstPause.
  void refuse(tables::Time now, Answer answer) noexcept {
    tried_ = true;
    if (answer == Answer::busy) {
      next_ = now;
      return;
    }
    next_ = refusals_ == 0 ? now : now + pause_;
    if (refusals_ != 0) pause_ = std::min(2 * pause_, kLongestPause);
    ++refusals_;
  }

 private:
  unsigned refusals_ = 0;
  bool tried_ = true;
  tables::Time pause_ = kFirstPause;  ///< after the next refusal, unless it is the first
  tables::Time next_ = 0;
};

}  // namespace symplant::link::client
