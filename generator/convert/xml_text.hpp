// Text in XML.
#pragma once

#include <string>
#include <string_view>

namespace symplant::convert {

/// Whether XML 1.0 can hold the text: no control characters except TAB and line ends, no U+FFFE and U+FFFF.
bool is_xml_text(std::string_view utf8);

/// Appends text for an element or a quoted attribute, so that a reader gets the same text. Characters that XML cannot
/// hold become blanks.
void append_xml(std::string& xml, std::string_view utf8);

}  // namespace symplant::convert
