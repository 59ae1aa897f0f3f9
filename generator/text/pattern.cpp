// Matches patterns with `*` and `?`.
#include "text/pattern.hpp"

#include <algorithm>
#include <cstddef>

#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::text {

namespace {

/// Calls `share(begin, end)` for what each wildcard matches, and `forget(count)` to take back all but the first
/// `count` calls. Of a text that matches, extending the last `*` alone is enough: a run of an earlier one that is
/// longer leaves less text to the same rest of the pattern.
template <class Share, class Forget>
bool match(std::string_view text, std::string_view pattern, Share share, Forget forget) {
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
      while (t < text.size() && is_continuation(text[t]));
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

}  // namespace

bool matches_pattern(std::string_view text, std::string_view pattern) {
  return match(
      text, pattern, [](std::size_t, std::size_t) {}, [](std::size_t) {});
}

std::vector<std::string_view> wildcard_shares(std::string_view text, std::string_view pattern) {
  std::vector<std::string_view> shares;
  const bool matches = match(
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
