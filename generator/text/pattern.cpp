// Matches patterns with `*` and `?`.
#include "text/pattern.hpp"

#include <algorithm>
#include <cstddef>

#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::text {

bool matches_pattern(std::string_view text, std::string_view pattern) {
  std::size_t t = 0;
  std::size_t p = 0;
  std::size_t star = pattern.npos;  // the last `*`, and the end of the text that it covers
  std::size_t reached = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      reached = t;
    } else if (p < pattern.size() && pattern[p] == '?') {
      ++p;
      do ++t;
      while (t < text.size() && is_continuation(text[t]));
    } else if (p < pattern.size() && upper(pattern[p]) == upper(text[t])) {
      ++p;
      ++t;
    } else if (star != pattern.npos) {
      p = star + 1;
      t = ++reached;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

std::size_t literal_characters(std::string_view pattern) {
  return count_code_points(pattern) - static_cast<std::size_t>(std::count_if(
                                          pattern.begin(), pattern.end(), [](char c) { return c == '*' || c == '?'; }));
}

}  // namespace symplant::text
