// Code points in UTF-8, one at a time.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace symplant::text {

inline constexpr char32_t kReplacementCharacter = 0xFFFD;

struct CodePoint {
  char32_t value;
  std::size_t length;  ///< bytes, 1 to 4
  bool valid;          ///< false: `value` is U+FFFD and stands for `length` bytes that are no UTF-8
};

/// The code point that begins at `offset`, which must lie in `text`. Strict: overlong forms, surrogates, numbers beyond
/// U+10FFFF and cut sequences are not valid.
CodePoint code_point_at(std::string_view text, std::size_t offset);

/// `value` must be a code point other than a surrogate.
void append_utf8(std::string& text, char32_t value);

/// True for the bytes of a character after its first.
constexpr bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// Characters in UTF-8 `text`.
std::size_t count_code_points(std::string_view text);

}  // namespace symplant::text
