// Cells that a spreadsheet would take for formulas (CWE-1236), and their protection.
#include "text/formula.hpp"

#include <algorithm>
#include <array>

#include "text/ascii.hpp"

namespace symplant::text {
namespace {

/// In full width, as input methods of East Asia write them: = + - @
constexpr std::array<std::string_view, 4> kWideSigns{"\xEF\xBC\x9D", "\xEF\xBC\x8B", "\xEF\xBC\x8D", "\xEF\xBC\xA0"};

bool is_sign(char c) { return c == '+' || c == '-'; }

/// Removes digits, and returns whether there were any.
bool take_digits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  const auto count = static_cast<std::size_t>(end - text.begin());
  text.remove_prefix(count);
  return count != 0;
}

/// -5, +1.5e-3
bool is_signed_number(std::string_view text) {
  if (!text.empty() && is_sign(text.front())) text.remove_prefix(1);
  if (!take_digits(text)) return false;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    if (!take_digits(text)) return false;
  }
  if (!text.empty() && upper(text.front()) == 'E') {
    text.remove_prefix(1);
    if (!text.empty() && is_sign(text.front())) text.remove_prefix(1);
    if (!take_digits(text)) return false;
  }
  return text.empty();
}

std::string_view without_apostrophes(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of('\''), text.size()));
}

}  // namespace

bool is_formula(std::string_view utf8) {
  if (utf8.empty()) return false;
  const bool begins =
      std::string_view("=+-@\t\r\n").find(utf8.front()) != std::string_view::npos ||
      std::any_of(kWideSigns.begin(), kWideSigns.end(), [&](std::string_view sign) { return utf8.starts_with(sign); });
  return begins && !is_signed_number(utf8) && !std::all_of(utf8.begin(), utf8.end(), is_sign);
}

bool needs_protection(std::string_view utf8) { return is_formula(without_apostrophes(utf8)); }

std::string_view unprotected(std::string_view cell) {
  return cell.starts_with('\'') && needs_protection(cell) ? cell.substr(1) : cell;
}

}  // namespace symplant::text
