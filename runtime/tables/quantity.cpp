// Parses numbers with a unit.
#include "symplant/tables/quantity.hpp"

#include <cstddef>
#include <limits>
#include <numeric>

#include "symplant/tables/ascii.hpp"

namespace symplant::tables {
namespace {

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
/// The 14th decimal of an hour is less than a nanosecond.
constexpr std::size_t kMostDecimals = 13;

constexpr bool is_blank(char c) noexcept { return c == ' ' || c == '\t'; }

std::size_t digits(std::string_view text) noexcept {
  std::size_t count = 0;
  while (count < text.size() && is_digit(text[count])) ++count;
  return count;
}

}  // namespace

std::optional<std::int64_t> parse_quantity(std::string_view text, std::span<const Unit> units) noexcept {
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

  std::int64_t size = 0;
  for (const Unit& unit : units) {
    if (unit.name == text) size = unit.size;
  }
  if (size == 0) return std::nullopt;

  std::int64_t value = 0;
  for (const char c : whole) {
    const std::int64_t digit = c - '0';
    if (value > (kMost - digit) / 10) return std::nullopt;
    value = value * 10 + digit;
  }
  if (value > kMost / size) return std::nullopt;
  value *= size;
  while (!fraction.empty() && fraction.back() == '0') fraction.remove_suffix(1);
  if (fraction.size() > kMostDecimals) return std::nullopt;
  std::int64_t digits_after = 0;
  std::int64_t ten_to_their_number = 1;
  for (const char c : fraction) {
    digits_after = digits_after * 10 + (c - '0');
    ten_to_their_number *= 10;
  }
  // digits_after * size / ten_to_their_number, which is less than size, without overflow.
  const std::int64_t common = std::gcd(size, ten_to_their_number);
  if (digits_after % (ten_to_their_number / common) != 0) return std::nullopt;
  const std::int64_t part = digits_after / (ten_to_their_number / common) * (size / common);
  if (value > kMost - part) return std::nullopt;
  value += part;
  if (value == kMost) return std::nullopt;
  return value;
}

}  // namespace symplant::tables
