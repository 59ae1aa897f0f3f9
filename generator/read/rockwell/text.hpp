// Decodes the escapes in texts of Logix exports.
#pragma once

#include <string>
#include <string_view>

namespace symplant::read {

/// The text of a description: `$XXXX` is a UTF-16 unit, `$N`, `$L`, `$R` and `$P` are line ends (`$R$L` is one), `$T`
/// is a TAB, `$Q` a double quote; after `$`, `$` and quotes mean themselves. Control characters become blanks, lone
/// surrogates U+FFFD. An unknown escape stays as written. Blanks and line ends around the text are removed. O(text).
std::string decode_rockwell_text(std::string_view text);

}  // namespace symplant::read
