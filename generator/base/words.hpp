// Looking at eight bytes of a text at once.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace symplant::base {

inline constexpr std::uint64_t kLowBits = 0x0101010101010101U;
inline constexpr std::uint64_t kHighBits = 0x8080808080808080U;

/// Eight bytes, the first of them lowest whatever the machine's byte order.
inline std::uint64_t load_word(const char* bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
  return word;
}

/// `byte` eight times over.
constexpr std::uint64_t spread(char byte) { return kLowBits * static_cast<unsigned char>(byte); }

/// Not zero if a byte of the word is zero; the lowest bit set then tells the first (bits above it may be wrong).
constexpr std::uint64_t zero_bytes(std::uint64_t word) { return (word - kLowBits) & ~word & kHighBits; }

/// Which byte, counted from 0, the lowest bit set of such a mask tells.
constexpr std::size_t first_byte(std::uint64_t mask) { return static_cast<std::size_t>(std::countr_zero(mask)) / 8; }

/// Where the first of three characters stands at or after `from`; the text's size where none does.
inline std::size_t find_any(std::string_view text, std::size_t from, char a, char b, char c) {
  const std::uint64_t as = spread(a);
  const std::uint64_t bs = spread(b);
  const std::uint64_t cs = spread(c);
  for (; text.size() - from >= 8; from += 8) {
    const std::uint64_t word = load_word(text.data() + from);
    const std::uint64_t found = zero_bytes(word ^ as) | zero_bytes(word ^ bs) | zero_bytes(word ^ cs);
    if (found != 0) return from + first_byte(found);
  }
  while (from < text.size() && text[from] != a && text[from] != b && text[from] != c) ++from;
  return from;
}

}  // namespace symplant::base
