// The words of a symbol's name.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace symplant::text {

/// Calls `take(word)` for each word of a name, until it returns true; returns whether it did. A word is letters, bytes
/// above 127 among them, and begins at a capital after a small letter, too: `tankLevel_2` has `tank` and `Level`.
/// O(name).
template <class Take>
bool any_word(std::string_view name, Take take) {
  const auto is_upper = [](char c) { return c >= 'A' && c <= 'Z'; };
  const auto is_letter = [&](char c) { return is_upper(c) || (c >= 'a' && c <= 'z') || (c & '\x80') != 0; };
  for (std::size_t begin = 0; begin < name.size();) {
    std::size_t end = begin;
    while (end < name.size() && is_letter(name[end]) &&
           (end == begin || !is_upper(name[end]) || is_upper(name[end - 1]))) {
      ++end;
    }
    if (end > begin && take(name.substr(begin, end - begin))) return true;
    begin = std::max(end, begin + 1);
  }
  return false;
}

/// A name with each run of digits replaced by a mark. O(name).
inline std::string without_numbers(std::string_view name, char mark) {
  std::string shape;
  for (const char c : name) {
    const bool digit = c >= '0' && c <= '9';
    if (!digit || shape.empty() || shape.back() != mark) shape += digit ? mark : c;
  }
  return shape;
}

}  // namespace symplant::text
