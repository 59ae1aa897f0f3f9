// Parses durations such as "500ms".
#include "symplant/tables/duration.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "symplant/tables/ascii.hpp"

namespace symplant::tables {
namespace {

struct Unit {
  std::string_view name;
  Time length;
};
constexpr std::array<Unit, 6> kUnits{{{"ns", 1},
                                      {"us", kMicrosecond},
                                      {"ms", kMillisecond},
                                      {"s", kSecond},
                                      {"min", 60 * kSecond},
                                      {"h", 3600 * kSecond}}};

/// The 14th decimal of an hour is less than a nanosecond.
constexpr std::size_t kMostDecimals = 13;

constexpr bool is_blank(char c) noexcept { return c == ' ' || c == '\t'; }

std::size_t digits(std::string_view text) noexcept {
  std::size_t count = 0;
  while (count < text.size() && is_digit(text[count])) ++count;
  return count;
}

}  // namespace

std::optional<Time> parse_duration(std::string_view text) noexcept {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  const std::string_view whole = text.substr(0, digits(text));
  text.remove_prefix(whole.size());
  std::string_view fraction;
  if (!text.empty() && text.front() == '.') {
    text.remove_prefix(1);
    fraction = text.substr(0, digits(text));
    text.remove_prefix(fraction.size());
    if (fraction.empty()) return std::nullopt;
  }
  if (whole.empty()) return std::nullopt;
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);

  Time length = 0;
  for (const Unit& unit : kUnits) {
    if (unit.name == text) length = unit.length;
  }
  if (length == 0) return std::nullopt;

  Time value = 0;
  for (const char c : whole) {
    const Time digit = c - '0';
    if (value > (kNever - digit) / 10) return std::nullopt;
    value = value * 10 + digit;
  }
  if (value > kNever / length) return std::nullopt;
  value *= length;
  while (!fraction.empty() && fraction.back() == '0') fraction.remove_suffix(1);
  if (fraction.size() > kMostDecimals) return std::nullopt;
  Time digits_after = 0;
  Time ten_to_their_number = 1;
  for (const char c : fraction) {
    digits_after = digits_after * 10 + (c - '0');
    ten_to_their_number *= 10;
  }
  // digits_after * length / ten_to_their_number, which is less than length, without overflow.
  const Time common = std::gcd(length, ten_to_their_number);
  if (digits_after % (ten_to_their_number / common) != 0) return std::nullopt;
  const Time part = digits_after / (ten_to_their_number / common) * (length / common);
  if (value > kNever - part) return std::nullopt;
  value += part;
  if (value == kNever) return std::nullopt;
  return value;
}

}  // namespace symplant::tables
