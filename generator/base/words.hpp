// Searches a text eight bytes at a time.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace symplant::base {

inline constexpr std::uint64_t kLowBits = 0x0101010101010101U;
inline constexpr std::uint64_t kHighBits = 0x8080808080808080U;

/// Eight bytes as a number, the first byte lowest, on machines of either byte order.
inline std::uint64_t load_word(const char* bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
  return word;
}

/// `byte` repeated eight times.
constexpr std::uint64_t spread(char byte) { return kLowBits * static_cast<unsigned char>(byte); }

/// Nonzero if a byte of the word is zero; its lowest set bit is in the first such byte (bits above it may be wrong).
constexpr std::uint64_t zero_bytes(std::uint64_t word) { return (word - kLowBits) & ~word & kHighBits; }

/// The byte, counted from 0, of the lowest set bit in a mask of zero_bytes().
constexpr std::size_t first_byte(std::uint64_t mask) { return static_cast<std::size_t>(std::countr_zero(mask)) / 8; }

/// The first offset, from `from` on, of one of three characters; the text's size if there is none.
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
