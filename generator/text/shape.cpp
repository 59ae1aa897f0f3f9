// Replaces digits and blanks.
#include "text/shape.hpp"

#include "text/ascii.hpp"

namespace symplant::text {

namespace {

/// The length of ST, ND, RD or TH at an index, with no letter after it; else 0.
std::size_t ordinal_at(std::string_view text, std::size_t at) {
  const auto is_letter = [](char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; };
  if (at + 2 > text.size() || (at + 2 < text.size() && is_letter(text[at + 2]))) return 0;
  const std::string_view ending = text.substr(at, 2);
  for (const std::string_view known : {"ST", "ND", "RD", "TH"}) {
    if (equal_ignoring_case(ending, known)) return known.size();
  }
  return 0;
}

}  // namespace

std::string shape_of(std::string_view text) {
  std::string shape;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (const std::size_t ordinal = shape.ends_with('#') && i > 0 && is_digit(text[i - 1]) ? ordinal_at(text, i) : 0) {
      shape += "TH";
      i += ordinal - 1;
      continue;
    }
    const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    const char as = is_digit(c) ? '#' : blank ? ' ' : c;
    const bool repeated = (as == '#' && c != '#') || blank;
    if (!repeated || shape.empty() || shape.back() != as) shape += as;
  }
  return shape;
}

}  // namespace symplant::text
