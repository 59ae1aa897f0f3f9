// Matches patterns with `*` and `?`.
#include "text/pattern.hpp"

#include <algorithm>
#include <cstddef>

#include "text/utf8.hpp"

namespace symplant::text {

std::vector<std::string_view> wildcard_shares(std::string_view text, std::string_view pattern) {
  std::vector<std::string_view> shares;
  const bool matches = tables::match_pattern(
      text, pattern, [&](std::size_t begin, std::size_t end) { shares.push_back(text.substr(begin, end - begin)); },
      [&](std::size_t count) { shares.resize(count); });
  if (!matches) shares.clear();
  return shares;
}

std::size_t literal_characters(std::string_view pattern) {
  return count_code_points(pattern) - static_cast<std::size_t>(std::count_if(
                                          pattern.begin(), pattern.end(), [](char c) { return c == '*' || c == '?'; }));
}

}  // namespace symplant::text
