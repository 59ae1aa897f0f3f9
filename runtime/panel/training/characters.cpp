// The characters of texts that people write to each other.
#include "symplant/panel/training/characters.hpp"

#include <cstdint>

namespace symplant::panel {
namespace {

/// The first character of a text, which becomes shorter by it; nothing if it is not valid UTF-8.
std::optional<char32_t> take_character(std::string_view& text) {
  const auto first = static_cast<std::uint8_t>(text.front());
  const std::size_t more = first < 0x80 ? 0 : first < 0xC2 ? 4 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
  if (more == 4 || first > 0xF4 || text.size() <= more) return std::nullopt;
  char32_t character = more == 0 ? first : first & (0x3FU >> more);
  for (std::size_t i = 1; i <= more; ++i) {
    const auto byte = static_cast<std::uint8_t>(text[i]);
    if ((byte & 0xC0U) != 0x80) return std::nullopt;
    character = character << 6U | (byte & 0x3FU);
  }
  constexpr char32_t kLeast[] = {0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = character >= 0xD800 && character < 0xE000;
  if (character < kLeast[more] || character > 0x10FFFF || is_surrogate) return std::nullopt;
  text.remove_prefix(more + 1);
  return character;
}

bool is_text(char32_t character) {
  const auto within = [character](char32_t from, char32_t to) { return character >= from && character <= to; };
  const bool is_control = character < 0x20 || within(0x7F, 0x9F);
  const bool is_separator = within(0x2028, 0x2029);
  const bool turns = within(0x200E, 0x200F) || within(0x202A, 0x202E) || within(0x2066, 0x2069) || character == 0x61C;
  const bool is_noncharacter = (character & 0xFFFE) == 0xFFFE || within(0xFDD0, 0xFDEF) || character == 0xFEFF;
  return !(is_control || is_separator || turns || is_noncharacter);
}

}  // namespace

std::optional<std::size_t> characters_of(std::string_view utf8, bool lines) {
  std::size_t count = 0;
  for (; !utf8.empty(); ++count) {
    const std::optional<char32_t> character = take_character(utf8);
    if (!character || !(is_text(*character) || (lines && *character == '\n'))) return std::nullopt;
  }
  return count;
}

}  // namespace symplant::panel
