// Replaces digits and blanks.
#include "text/shape.hpp"

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

}  // namespace

std::string shape_of(std::string_view text) {
  std::string shape(text.size(), '\0');  // it is never longer
  std::size_t size = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const char before = size == 0 ? '\0' : shape[size - 1];
    if (is_digit(c)) {
      if (before != '#') shape[size++] = '#';
    } else if (before == '#' && is_digit(text[i - 1]) && is_ordinal_at(text, i)) {
      shape[size++] = 'T';
      shape[size++] = 'H';
      ++i;
    } else if (c != ' ' && c != '\t' && c != '\r' && c != '\n') {
      shape[size++] = c;
    } else if (before != ' ') {
      shape[size++] = ' ';
    }
  }
  shape.resize(size);
  return shape;
}

}  // namespace symplant::text
