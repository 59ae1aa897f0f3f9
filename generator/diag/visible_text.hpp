// A user's text made safe to show on a terminal, and how wide it is there.
#pragma once

#include <string>
#include <string_view>

namespace symplant::diag {

/// Columns that a character takes on a terminal: 0 (combining), 1 or 2 (East Asian wide).
int display_width(char32_t point);

/// True for what a terminal must not get from a user's text: control characters, bidi controls, invisible characters.
bool is_unsafe(char32_t point);

/// `<U+202E>`
std::string escaped(char32_t point);

/// The text with each unsafe character, line ends and tabs too, written as `<U+XXXX>`. `text` is UTF-8; what is not
/// shows as U+FFFD.
std::string visible(std::string_view text);

}  // namespace symplant::diag
