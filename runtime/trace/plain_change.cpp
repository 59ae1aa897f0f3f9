// Scans the usual line of a trace: a change of a symbol.
#include "symplant/trace/plain_change.hpp"

#include <charconv>
#include <cstddef>

namespace symplant::trace {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The end of the digits from `at` on.
std::size_t end_of_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

/// Whether a text is a number by the grammar of JSON, and not a negative zero, of which JSON readers drop the sign.
bool is_number(std::string_view text) {
  const bool negative = !text.empty() && text[0] == '-';
  const std::size_t begin = negative ? 1 : 0;
  std::size_t at = end_of_digits(text, begin);
  if (at == begin || (text[begin] == '0' && (at > begin + 1 || negative))) return false;
  if (at < text.size() && text[at] == '.') {
    const std::size_t fraction = at + 1;
    at = end_of_digits(text, fraction);
    if (at == fraction) return false;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t exponent = at + 1;
    if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
    at = end_of_digits(text, exponent);
    if (at == exponent) return false;
  }
  return at == text.size();
}

/// Takes `prefix` off the text, if it begins with it.
bool take(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

bool take_time(std::string_view& text, tables::Time& time) {
  constexpr std::size_t kMostDigits = 18;  // all of these fit
  const std::size_t digits = end_of_digits(text.substr(0, kMostDigits + 1), 0);
  if (digits == 0 || digits > kMostDigits || (text[0] == '0' && digits > 1)) return false;
  time = 0;
  for (const char c : text.substr(0, digits)) time = time * 10 + (c - '0');
  text.remove_prefix(digits);
  return true;
}

bool take_name(std::string_view& text, std::string_view& name) {
  std::size_t at = 0;
  while (at < text.size() && text[at] != '"') {
    const auto byte = static_cast<unsigned char>(text[at]);
    if (byte < 0x20 || byte >= 0x80 || byte == '\\') return false;
    ++at;
  }
  name = text.substr(0, at);
  text.remove_prefix(at);
  return true;
}

}  // namespace

std::optional<PlainChange> plain_change(std::string_view line) {
  PlainChange change;
  if (!take(line, "{\"t\":") || !take_time(line, change.time) || !take(line, ",\"symbol\":\"") ||
      !take_name(line, change.symbol) || !take(line, "\",\"value\":") || line.empty() || line.back() != '}') {
    return std::nullopt;
  }
  line.remove_suffix(1);
  change.is_boolean = line == "true" || line == "false";
  if (change.is_boolean) {
    change.value = line == "true" ? 1 : 0;
    return change;
  }
  if (!is_number(line)) return std::nullopt;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), change.value);
  return error == std::errc() ? std::optional(change) : std::nullopt;
}

}  // namespace symplant::trace
