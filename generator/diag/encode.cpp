// Encoders for output that other programs show.
#include "diag/encode.hpp"

#include "diag/visible_text.hpp"
#include "text/utf8.hpp"

namespace symplant::diag {
namespace {

constexpr std::string_view kLineSeparator = "\xE2\x80\xA8";  // U+2028 and U+2029 end a line in JavaScript strings
constexpr std::string_view kParagraphSeparator = "\xE2\x80\xA9";
constexpr std::string_view kHarmlessInMermaid = " _-.,()/=+*'";

bool is_ascii_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Replaces U+FFFE and U+FFFF, which XML cannot represent.
std::string without_noncharacters(std::string_view utf8) {
  std::string text;
  for (std::size_t at = 0; at < utf8.size();) {
    const text::CodePoint point = text::code_point_at(utf8, at);
    if ((point.value & 0xFFFEU) == 0xFFFEU) {
      text += escaped(point.value);
    } else {
      text += utf8.substr(at, point.length);
    }
    at += point.length;
  }
  return text;
}

}  // namespace

std::string markup_text(std::string_view utf8) {
  std::string text;
  for (const char c : without_noncharacters(visible(utf8))) {
    switch (c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      case '\'':
        text += "&#39;";
        break;
      default:
        text += c;
    }
  }
  return text;
}

std::string script_json(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (std::size_t at = 0; at < json.size(); ++at) {
    const std::string_view three = json.substr(at, 3);
    if (three == kLineSeparator || three == kParagraphSeparator) {
      text += three == kLineSeparator ? "\\u2028" : "\\u2029";
      at += 2;
    } else if (json[at] == '<') {
      text += "\\u003c";
    } else if (json[at] == '>') {
      text += "\\u003e";
    } else if (json[at] == '&') {
      text += "\\u0026";
    } else {
      text += json[at];
    }
  }
  return text;
}

std::string dot_text(std::string_view utf8) {
  std::string text;
  for (const char c : visible(utf8)) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
    if (c == '&') text += "amp;";  // Graphviz reads entities in labels
  }
  return text;
}

std::string dot_string(std::string_view utf8) { return "\"" + dot_text(utf8) + "\""; }

std::string sarif_text(std::string_view utf8) {
  const std::string shown = visible(utf8);
  std::string text;
  for (std::size_t at = 0; at < shown.size(); ++at) {
    const char next = at + 1 < shown.size() ? shown[at + 1] : '\0';
    const bool link = shown[at] == ']' && next == '(';
    const bool argument = shown[at] == '{' && next >= '0' && next <= '9';
    if (link || argument) {
      text += escaped(static_cast<unsigned char>(shown[at]));
    } else {
      text += shown[at];
    }
  }
  return text;
}

std::string mermaid_text(std::string_view utf8) {
  std::string text;
  for (const char c : visible(utf8)) {
    const bool harmless = static_cast<unsigned char>(c) >= 0x80 || is_ascii_letter_or_digit(c) ||
                          kHarmlessInMermaid.find(c) != std::string_view::npos;
    if (harmless) {
      text += c;
    } else {
      text.append("#").append(std::to_string(static_cast<unsigned char>(c))).append(";");
    }
  }
  return text;
}

std::string markdown_code(std::string_view utf8) {
  const std::string shown = visible(utf8);
  if (shown.empty()) return {};
  const bool blank_end = shown.front() == ' ' || shown.back() == ' ';
  if (!blank_end && shown.find_first_of("`|\\") == std::string::npos) return "`" + shown + "`";
  std::string text = "<code>";
  for (const char c : shown) {
    if (static_cast<unsigned char>(c) >= 0x80 || is_ascii_letter_or_digit(c)) {
      text += c;
    } else {
      text.append("&#").append(std::to_string(static_cast<unsigned char>(c))).append(";");
    }
  }
  return text + "</code>";
}

}  // namespace symplant::diag
