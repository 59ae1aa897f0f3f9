// Matches patterns with `*` and `?`.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "symplant/tables/pattern.hpp"

namespace symplant::text {

using tables::matches_pattern;

/// What each `*` and `?` of a matching pattern matches: a `*` the shortest run, from the left, that lets the
/// rest match. Empty if the pattern does not match. O(text * pattern) at worst.
std::vector<std::string_view> wildcard_shares(std::string_view text, std::string_view pattern);

/// How many characters of a pattern are neither `*` nor `?`.
std::size_t literal_characters(std::string_view pattern);

/// Whether a name has wildcards. O(the name).
inline bool is_pattern(std::string_view name) { return name.find_first_of("*?") != std::string_view::npos; }

}  // namespace symplant::text
