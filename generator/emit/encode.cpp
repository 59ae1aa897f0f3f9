// One encoder for each context.
#include "emit/encode.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "text/utf8.hpp"

namespace symplant::emit {
namespace {

/// Bytes that need no encoding, neither in comments nor in literals.
constexpr auto kPlain = [] {
  std::array<bool, 256> plain{};
  for (unsigned c = ' '; c <= '~'; ++c) plain[c] = c != '\\' && c != '"' && c != '?';
  return plain;
}();

std::size_t plain_bytes(std::string_view text) {
  std::size_t size = 0;
  while (size < text.size() && kPlain[static_cast<unsigned char>(text[size])]) ++size;
  return size;
}

}  // namespace

std::size_t plain_in_comment(std::string_view utf8) { return plain_bytes(utf8); }
std::size_t plain_in_literal(std::string_view bytes) { return plain_bytes(bytes); }

void append_comment(std::string& out, std::string_view utf8) {
  for (std::size_t at = 0; at < utf8.size();) {
    const char c = utf8[at];
    const bool second_question_mark = c == '?' && !out.empty() && out.back() == '?';
    const bool end_in_st = c == '*' && utf8.substr(at + 1).starts_with(')');
    if (c >= ' ' && c <= '~' && c != '\\' && !second_question_mark && !end_in_st) {
      out += c;
      ++at;
      continue;
    }
    const text::CodePoint point = text::code_point_at(utf8, at);
    fmt::format_to(std::back_inserter(out), "<U+{:04X}>", static_cast<std::uint32_t>(point.value));
    at += point.length;
  }
}

std::string comment_text(std::string_view utf8) {
  std::string out;
  append_comment(out, utf8);
  return out;
}

void append_literal(std::string& out, std::string_view bytes) {
  for (const char c : bytes) {
    if (c >= ' ' && c <= '~' && c != '\\' && c != '"' && c != '?') {
      out += c;
    } else {
      const auto value = static_cast<unsigned char>(c);
      out += '\\';
      out += static_cast<char>('0' + (value >> 6));
      out += static_cast<char>('0' + ((value >> 3) & 7));
      out += static_cast<char>('0' + (value & 7));
    }
  }
}

std::string string_literal(std::string_view bytes) {
  std::string out = "\"";
  append_literal(out, bytes);
  return out += '"';
}

}  // namespace symplant::emit
