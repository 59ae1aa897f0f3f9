// Text in the markup of manual pages.
#include "app/roff.hpp"

namespace symplant::app {
namespace {

/// The escape sequence of a character that roff changes or interprets; empty for others.
std::string_view roff_escape(char character) {
  switch (character) {
    case '\\':
      return "\\(rs";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '"':
      return "\\(dq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return {};
  }
}

}  // namespace

std::string roff(std::string_view text) {
  std::string escaped;
  bool line_starts = true;
  for (const char character : text) {
    const std::string_view escape = roff_escape(character);
    if (line_starts && character == '.') escaped += "\\&";  // a dot that begins a line begins a macro
    if (escape.empty()) {
      escaped += character;
    } else {
      escaped += escape;
    }
    line_starts = character == '\n';
  }
  return escaped;
}

std::string roff_bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string roff_italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

}  // namespace symplant::app
