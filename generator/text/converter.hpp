// Converts the bytes of a legacy code page by the system.
#pragma once

#include <string>
#include <string_view>

#include "text/encoding_names.hpp"

namespace symplant::text {

/// Whether this system knows a code page.
bool can_convert(Encoding encoding);

/// UTF-8 of the bytes up to the first one that is invalid in a code page, or means a control character beyond ASCII;
/// `rest` is the part from there on, empty at the end. Call only if can_convert(). O(bytes).
std::string convert(Encoding encoding, std::string_view bytes, std::string_view& rest);

}  // namespace symplant::text
