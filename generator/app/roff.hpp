// Text in the markup of manual pages (roff, with the macros of man(7)).
#pragma once

#include <string>
#include <string_view>

namespace symplant::app {

/// The text as roff shows it unchanged, anywhere in a page: in a line of text, at the start of a line, or in quotes as
/// the argument of a macro. Hyphens become minus signs, so that an option can be copied from the page. `text` is UTF-8;
/// characters outside ASCII are left as they are.
std::string roff(std::string_view text);

/// The same in bold, and in italics.
std::string roff_bold(std::string_view text);
std::string roff_italic(std::string_view text);

}  // namespace symplant::app
