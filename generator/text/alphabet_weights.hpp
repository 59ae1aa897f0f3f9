// How much a text beyond ASCII looks like words in Latin, Cyrillic or Greek letters.
#pragma once

#include <string_view>

#include "text/encoding.hpp"

namespace symplant::text {

/// script_weight() for code pages of alphabets; `text` is UTF-8.
double alphabet_weight(Encoding encoding, std::string_view text);

}  // namespace symplant::text
