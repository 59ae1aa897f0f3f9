// Patterns with * and ?.
#pragma once

#include <string_view>

namespace symplant::base {

/// Whether `pattern` fits the whole text: `*` is any run of characters, `?` one byte; ASCII case does not count.
/// O(text * pattern) at worst, no recursion.
bool matches_pattern(std::string_view text, std::string_view pattern);

}  // namespace symplant::base
