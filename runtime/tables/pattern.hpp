// Matches patterns with `*` and `?`.
#pragma once

#include <cstddef>
#include <string_view>

#include "symplant/tables/ascii.hpp"

namespace symplant::tables {

/// Whether `pattern` matches the whole text: `*` is any run of characters, `?` one character of UTF-8. ASCII case is
/// ignored. Calls `share(begin, end)` for what each wildcard matches, and `forget(count)` to take back all but the
/// first `count` calls. To find a match, it is enough to extend the last `*`: a longer run of an earlier `*` leaves
/// less text to the same rest of the pattern.
template <class Share, class Forget>
constexpr bool match_pattern(std::string_view text, std::string_view pattern, Share share, Forget forget) {
  std::size_t t = 0;
  std::size_t p = 0;
  std::size_t star = pattern.npos;  // the last `*`, the text from which it begins, and the end that it covers
  std::size_t begin = 0;
  std::size_t reached = 0;
  std::size_t shares = 0;
  std::size_t shares_before = 0;  // the last `*`
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      begin = reached = t;
      shares_before = shares++;
      share(begin, begin);
    } else if (p < pattern.size() && pattern[p] == '?') {
      ++p;
      const std::size_t from = t;
      do ++t;
      while (t < text.size() && (static_cast<unsigned char>(text[t]) & 0xC0U) == 0x80U);
      share(from, t);
      ++shares;
    } else if (p < pattern.size() && upper(pattern[p]) == upper(text[t])) {
      ++p;
      ++t;
    } else if (star != pattern.npos) {
      p = star + 1;
      t = ++reached;
      forget(shares_before);
      share(begin, reached);
      shares = shares_before + 1;
    } else {
      return false;
    }
  }
  for (; p < pattern.size() && pattern[p] == '*'; ++p) share(t, t);
  return p == pattern.size();
}

/// The same without shares. O(text * pattern) at worst, no recursion, no heap.
constexpr bool matches_pattern(std::string_view text, std::string_view pattern) noexcept {
  return match_pattern(
      text, pattern, [](std::size_t, std::size_t) {}, [](std::size_t) {});
}

}  // namespace symplant::tables
