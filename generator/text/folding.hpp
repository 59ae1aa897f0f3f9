// Makes texts equal that people read as equal: Unicode's normal form C and simple case folding.
#pragma once

#include <string>
#include <string_view>

namespace symplant::text {

/// `text`, which is UTF-8, in normal form C. O(text); ASCII is only copied.
std::string normal_form(std::string_view text);

/// Replaces `folded` by `text` with small letters for capital ones. Every character keeps its number of bytes, so that
/// offsets are the same in both: the few letters whose small form is longer or shorter stay as they are. O(text).
void fold_case(std::string_view text, std::string& folded);
std::string folded(std::string_view text);

/// The columns that a character takes on a terminal of fixed pitch: 0, 1 or 2.
int column_width(char32_t character);

}  // namespace symplant::text
