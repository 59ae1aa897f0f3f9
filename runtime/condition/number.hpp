// An exact decimal number, parsed from text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace symplant::condition {

/// An integer as sign and magnitude; `huge` if the magnitude exceeds 64 bits.
struct WholeNumber {
  bool negative = false;  ///< false for 0
  bool huge = false;
  std::uint64_t magnitude = 0;
};

/// The value is `digits` * 10^exponent, negated if `negative`.
struct Number {
  bool negative = false;
  std::string digits;  ///< decimal, without leading and trailing zeros: empty for 0
  std::int64_t exponent = 0;

  /// Parses `12`, `-3.5`, `1e3`, `16#FF`, `8#17`, `2#1010` (the last three below 2^64), with `_` between digits. Empty
  /// for any other text. O(text).
  static std::optional<Number> read(std::string_view text);

  bool is_whole() const { return digits.empty() || exponent >= 0; }
  /// The greatest integer <= the number. O(1).
  WholeNumber floor() const;
  /// The nearest double; empty if the number exceeds the largest double, or is not 0 but would round to 0. O(digits).
  std::optional<double> real() const;
};

}  // namespace symplant::condition
