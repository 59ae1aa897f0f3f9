// Replaces digits and blanks.
#include "text/shape.hpp"

#include <array>
#include <cstdint>

#include "text/ascii.hpp"

namespace symplant::text {

namespace {

/// Whether ST, ND, RD or TH is at an index, with no letter after it.
bool is_ordinal_at(std::string_view text, std::size_t at) {
  const auto is_letter = [](char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; };
  if (at + 2 > text.size() || !is_letter(text[at]) || (at + 2 < text.size() && is_letter(text[at + 2]))) return false;
  const std::string_view ending = text.substr(at, 2);
  for (const std::string_view known : {"ST", "ND", "RD", "TH"}) {
    if (equal_ignoring_case(ending, known)) return true;
  }
  return false;
}

enum class Kind : std::uint8_t { other, digit, blank };

constexpr auto kKinds = [] {
  std::array<Kind, 256> kinds{};
  for (unsigned char c = '0'; c <= '9'; ++c) kinds[c] = Kind::digit;
  for (const char c : std::string_view(" \t\r\n")) kinds[static_cast<unsigned char>(c)] = Kind::blank;
  return kinds;
}();

}  // namespace

std::string shape_of(std::string_view text) {
  std::string shape(text.size(), '\0');  // it is never longer
  char* end = shape.data();
  Kind before = Kind::other;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const Kind kind = kKinds[static_cast<unsigned char>(text[i])];
    if (kind == Kind::other) {
      if (before == Kind::digit && is_ordinal_at(text, i)) {
        *end++ = 'T';
        *end++ = 'H';
        ++i;
      } else {
        *end++ = text[i];
      }
    } else if (kind != before && (kind == Kind::blank || end == shape.data() || end[-1] != '#')) {
      *end++ = kind == Kind::digit ? '#' : ' ';
    }
    before = kind;
  }
  shape.resize(static_cast<std::size_t>(end - shape.data()));
  return shape;
}

}  // namespace symplant::text
