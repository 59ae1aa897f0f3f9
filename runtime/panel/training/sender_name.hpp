// The name that a client of the panel gives.
#pragma once

#include <string>
#include <string_view>

namespace symplant::panel {

/// What is wrong with a header `X-Symplant-Name` that read_sender_name() does not accept.
inline constexpr std::string_view kNameForm =
    "`X-Symplant-Name` is a name in percent-encoded UTF-8: at most 64 bytes when it is decoded, without control "
    "characters";

/// Reads the header `X-Symplant-Name`: percent-encoded UTF-8, without the blanks around it. An empty header gives an
/// empty name. False if the name is longer than 64 bytes, is not valid UTF-8, has only blanks, or has a control
/// character, a line end or a character that changes the direction of text. O(header).
bool read_sender_name(std::string_view header, std::string& name);

}  // namespace symplant::panel
