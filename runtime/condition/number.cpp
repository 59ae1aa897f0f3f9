// Reads numbers as sign, digits and exponent.
#include "symplant/condition/number.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

#include "symplant/tables/ascii.hpp"

namespace symplant::condition {
namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
/// Larger than every exponent that matters; sums of it cannot overflow.
constexpr std::int64_t kFarExponent = std::int64_t{1} << 40;

using tables::is_digit;

/// Removes the digits at the start of `text` and returns them without the single `_` between them.
std::string take_digits(std::string_view& text) {
  std::string digits;
  std::size_t at = 0;
  while (at < text.size()) {
    if (is_digit(text[at])) {
      digits += text[at];
    } else if (text[at] != '_' || digits.empty() || at + 1 == text.size() || !is_digit(text[at + 1])) {
      break;
    }
    ++at;
  }
  text.remove_prefix(at);
  return digits;
}

void normalise(Number& number) {
  const std::size_t first = number.digits.find_first_not_of('0');
  number.digits.erase(0, std::min(first, number.digits.size()));
  const std::size_t last = number.digits.find_last_not_of('0');
  const std::size_t kept = last == std::string::npos ? 0 : last + 1;
  number.exponent += static_cast<std::int64_t>(number.digits.size() - kept);
  number.digits.resize(kept);
  if (number.digits.empty()) number = {};
}

std::optional<Number> with_radix(std::string_view text, bool negative, int radix) {
  std::string digits;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool between = i > 0 && i + 1 < text.size() && text[i - 1] != '_';
    if (text[i] != '_') {
      digits += text[i];
    } else if (!between) {
      return std::nullopt;
    }
  }
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, radix);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  Number number{negative, std::to_string(value), 0};
  normalise(number);
  return number;
}

}  // namespace

std::optional<Number> Number::read(std::string_view text) {
  Number number;
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
    number.negative = text.front() == '-';
    text.remove_prefix(1);
  }
  if (text.starts_with("16#")) return with_radix(text.substr(3), number.negative, 16);
  if (text.starts_with("8#")) return with_radix(text.substr(2), number.negative, 8);
  if (text.starts_with("2#")) return with_radix(text.substr(2), number.negative, 2);

  number.digits = take_digits(text);
  if (number.digits.empty()) return std::nullopt;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    const std::string fraction = take_digits(text);
    if (fraction.empty()) return std::nullopt;
    number.digits += fraction;
    number.exponent = -static_cast<std::int64_t>(fraction.size());
  }
  if (text.starts_with('e') || text.starts_with('E')) {
    text.remove_prefix(1);
    const bool down = text.starts_with('-');
    if (down || text.starts_with('+')) text.remove_prefix(1);
    const std::string digits = take_digits(text);
    if (digits.empty()) return std::nullopt;
    std::int64_t exponent = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error != std::errc{} || exponent > kFarExponent) exponent = kFarExponent;
    number.exponent += down ? -exponent : exponent;
  }
  if (!text.empty()) return std::nullopt;
  normalise(number);
  return number;
}

WholeNumber Number::floor() const {
  const std::int64_t indexes = static_cast<std::int64_t>(digits.size()) + exponent;  // before the decimal point
  if (digits.empty()) return {};
  if (indexes > 20) return {negative, true, 0};
  WholeNumber whole{negative, false, 0};
  for (std::int64_t i = 0; i < indexes; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const std::uint64_t digit = index < digits.size() ? static_cast<std::uint64_t>(digits[index] - '0') : 0;
    if (whole.magnitude > (kMost - digit) / 10) return {negative, true, 0};
    whole.magnitude = whole.magnitude * 10 + digit;
  }
  if (negative && !is_whole()) {
    if (whole.magnitude == kMost) return {true, true, 0};
    ++whole.magnitude;
  }
  if (whole.magnitude == 0) whole.negative = false;
  return whole;
}

std::optional<double> Number::real() const {
  if (digits.empty()) return 0.0;
  const std::string text = (negative ? "-" : "") + digits + "e" + std::to_string(exponent);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value == 0) return std::nullopt;
  return value;
}

}  // namespace symplant::condition
