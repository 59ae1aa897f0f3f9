// Makes a user's text safe to show on a terminal, and measures its width there.
#pragma once

#include <string>
#include <string_view>

namespace symplant::diag {

/// Columns that a character takes on a terminal: 0 (combining), 1 or 2 (East Asian wide).
int display_width(char32_t point);

/// True for characters that must not reach a terminal: control characters, bidi controls, invisible characters.
bool is_unsafe(char32_t point);

/// `<U+202E>`
std::string escaped(char32_t point);

/// The text with each unsafe character, line ends and tabs too, written as `<U+XXXX>`. `text` is UTF-8;
/// invalid bytes become U+FFFD.
std::string visible(std::string_view text);

}  // namespace symplant::diag
