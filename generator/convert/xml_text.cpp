// Text in XML.
#include "convert/xml_text.hpp"

#include <algorithm>

namespace symplant::convert {
namespace {

bool is_xml_character(char c) { return static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n' || c == '\r'; }

/// U+FFFE and U+FFFF in UTF-8.
bool is_noncharacter(std::string_view text) {
  return text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF");
}

/// What a character is written as; empty: as it is.
std::string_view entity(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\r':
      return "&#13;";
    case '\n':
      return "&#10;";
    case '\t':
      return "&#9;";
    default:
      return {};
  }
}

}  // namespace

bool is_xml_text(std::string_view utf8) {
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    if (!is_xml_character(utf8[i]) || (utf8[i] == '\xEF' && is_noncharacter(utf8.substr(i)))) return false;
  }
  return true;
}

void append_xml(std::string& xml, std::string_view utf8) {
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const char c = utf8[i];
    const std::string_view special = entity(c);
    if (!special.empty()) {
      xml += special;
    } else if (!is_xml_character(c)) {
      xml += ' ';
    } else if (c == '\xEF' && is_noncharacter(utf8.substr(i))) {
      xml += ' ';
      i += 2;
    } else {
      xml += c;
    }
  }
}

}  // namespace symplant::convert
