// A number as people write it, kept exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace symplant::condition {

/// An integer as sign and magnitude; `huge` where the magnitude is beyond 64 bits.
struct WholeNumber {
  bool negative = false;  ///< false for 0
  bool huge = false;
  std::uint64_t magnitude = 0;
};

/// The value is `digits` * 10^exponent, negative or not.
struct Number {
  bool negative = false;
  std::string digits;  ///< decimal, without leading and trailing zeros: empty for 0
  std::int64_t exponent = 0;

  /// Reads `12`, `-3.5`, `1e3`, `16#FF`, `8#17`, `2#1010` (those below 2^64), with `_` between digits. Nothing where
  /// the text is none of these. O(text).
  static std::optional<Number> read(std::string_view text);

  bool is_whole() const { return digits.empty() || exponent >= 0; }
  /// The greatest integer that is not above it. O(1).
  WholeNumber floor() const;
  /// The nearest double; nothing where it is beyond the largest, or not 0 but nearest to 0. O(digits).
  std::optional<double> real() const;
};

}  // namespace symplant::condition
