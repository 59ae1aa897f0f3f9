// Matches patterns with `*` and `?`.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace symplant::text {

/// Whether `pattern` matches the whole text: `*` is any run of characters, `?` one character. ASCII case is ignored.
/// O(text * pattern) at worst, no recursion.
bool matches_pattern(std::string_view text, std::string_view pattern);

/// What each `*` and `?` of a matching pattern matches: a `*` the shortest run, from the left, that lets the
/// rest match. Empty if the pattern does not match. O(text * pattern) at worst.
std::vector<std::string_view> wildcard_shares(std::string_view text, std::string_view pattern);

/// How many characters of a pattern are neither `*` nor `?`.
std::size_t literal_characters(std::string_view pattern);

}  // namespace symplant::text
