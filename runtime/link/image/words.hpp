// Bits and lanes of 16 bits in the words of an image.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace symplant::link::image {

inline constexpr std::uint32_t kBitsPerWord = 64;
inline constexpr std::uint32_t kLanesPerWord = 4;
inline constexpr std::uint32_t kLaneBits = 16;

/// Number of words for `count` bits: 64 in a word, the lowest position in the lowest bit.
constexpr std::size_t bit_words(std::uint32_t count) { return (count + kBitsPerWord - 1) / kBitsPerWord; }
/// Number of words for `count` lanes: four in a word, the lowest one in the lowest 16 bits.
constexpr std::size_t lane_words(std::uint32_t count) { return (count + kLanesPerWord - 1) / kLanesPerWord; }

inline bool get_bit(std::span<const std::uint64_t> words, std::uint32_t position) noexcept {
  return (words[position / kBitsPerWord] >> (position % kBitsPerWord) & 1) != 0;
}

inline void set_bit(std::span<std::uint64_t> words, std::uint32_t position, bool on) noexcept {
  const std::uint64_t mask = std::uint64_t{1} << (position % kBitsPerWord);
  std::uint64_t& word = words[position / kBitsPerWord];
  word = on ? word | mask : word & ~mask;
}

/// The 64 bits from `position` on, the lowest position in the lowest bit; 0 after the last word.
inline std::uint64_t get_bits(std::span<const std::uint64_t> words, std::uint32_t position) noexcept {
  const std::uint32_t word = position / kBitsPerWord;
  const std::uint32_t shift = position % kBitsPerWord;
  const std::uint64_t low = words[word] >> shift;
  if (shift == 0 || word + 1 >= words.size()) return low;
  return low | words[word + 1] << (kBitsPerWord - shift);
}

/// Sets `count` bits (at most 64) from `position` on to the lowest ones of `bits`.
inline void set_bits(std::span<std::uint64_t> words, std::uint32_t position, std::uint64_t bits,
                     std::uint32_t count) noexcept {
  const std::uint32_t word = position / kBitsPerWord;
  const std::uint32_t shift = position % kBitsPerWord;
  const std::uint64_t mask = count == kBitsPerWord ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
  words[word] = (words[word] & ~(mask << shift)) | (bits & mask) << shift;
  if (shift + count <= kBitsPerWord) return;
  const std::uint32_t over = kBitsPerWord - shift;
  words[word + 1] = (words[word + 1] & ~(mask >> over)) | (bits & mask) >> over;
}

inline std::uint16_t get_lane(std::span<const std::uint64_t> words, std::uint32_t lane) noexcept {
  return static_cast<std::uint16_t>(words[lane / kLanesPerWord] >> (kLaneBits * (lane % kLanesPerWord)));
}

inline void set_lane(std::span<std::uint64_t> words, std::uint32_t lane, std::uint16_t value) noexcept {
  const std::uint32_t shift = kLaneBits * (lane % kLanesPerWord);
  std::uint64_t& word = words[lane / kLanesPerWord];
  word = (word & ~(std::uint64_t{0xFFFF} << shift)) | (std::uint64_t{value} << shift);
}

}  // namespace symplant::link::image
