// Looking at eight bytes of a text at once.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

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

}  // namespace symplant::base
