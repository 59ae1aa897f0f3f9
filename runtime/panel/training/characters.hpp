// The characters of texts that people write to each other.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace symplant::panel {

/// How many characters a text of UTF-8 has; nothing if it is not valid, or has a character that is not text: a control
/// character, a line or paragraph separator, a character that changes the direction of text, a noncharacter. With
/// `lines` a newline is text. O(text).
std::optional<std::size_t> characters_of(std::string_view utf8, bool lines);

}  // namespace symplant::panel
