// Percent-encoding, as in addresses.
#pragma once

#include <string>
#include <string_view>

namespace symplant::panel {

/// Decodes `%41` to `A` and so on; `plus_is_blank`: as in queries. False if an escape is not valid. O(text).
bool decode_percent(std::string_view text, bool plus_is_blank, std::string& decoded);

}  // namespace symplant::panel
