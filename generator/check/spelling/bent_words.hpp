// Two forms of one word: `CLAMP` and `CLAMPED`, `CLOSE` and `CLOSING`.
#pragma once

#include <string_view>

namespace symplant::check {

/// Whether two tasks that differ look like forms of one word: one begins with the other (three letters at least), or
/// they differ in an English ending. Sequence numbers must be the same. Without regard to case. O(length).
bool bent_alike(std::string_view a, std::string_view b);

}  // namespace symplant::check
