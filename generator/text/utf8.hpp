// Reads and writes code points in UTF-8.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace symplant::text {

inline constexpr char32_t kReplacementCharacter = 0xFFFD;

struct CodePoint {
  char32_t value;
  std::size_t length;  ///< bytes, 1 to 4
  bool valid;          ///< false: `value` is U+FFFD, in place of `length` bytes that are not UTF-8
};

/// The code point that begins at `offset`, which must be in `text`. Overlong forms, surrogates, numbers beyond U+10FFFF
/// and cut sequences are invalid.
CodePoint code_point_at(std::string_view text, std::size_t offset);

/// `value` must be a code point other than a surrogate.
void append_utf8(std::string& text, char32_t value);

/// True for every byte of a character except its first.
constexpr bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// The number of characters in UTF-8 `text`.
std::size_t count_code_points(std::string_view text);

/// The first characters of UTF-8 `text`, at most `most`.
std::string_view first_code_points(std::string_view text, std::size_t most);

}  // namespace symplant::text
