// How much a text, read in a code page, looks like a language that the code page is for.
#pragma once

#include <string_view>

#include "text/encoding.hpp"

namespace symplant::text {

/// 0 (noise) to 1: the mean over the characters beyond ASCII of how usual each is where it stands. `bytes` are in the
/// code page, `text` is their UTF-8; both are words parted by line ends. 0 for a code page that nobody judges. What is
/// looked at: Hangul of everyday use; kana, everyday kanji, katakana of half width in their order; everyday characters
/// of Chinese; letters of one script that stand as words do.
double script_weight(Encoding encoding, std::string_view bytes, std::string_view text);

}  // namespace symplant::text
