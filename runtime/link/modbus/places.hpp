// The four tables of a Modbus server as plain memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/link/io_map.hpp"

namespace symplant::link::modbus {

inline constexpr std::uint32_t kBitsPerWord = 64;
inline constexpr std::uint32_t kRegistersPerWord = 4;

/// The words that `places` bits take: 64 to a word, the lowest address in the lowest bit.
constexpr std::size_t bit_words(std::uint32_t places) { return (places + kBitsPerWord - 1) / kBitsPerWord; }
/// The words that `places` registers take: four to a word, the lowest address in the lowest 16 bits.
constexpr std::size_t register_words(std::uint32_t places) {
  return (places + kRegistersPerWord - 1) / kRegistersPerWord;
}

/// The words of one table and how many places it has; every word a place may lie in is there.
template <class Word>
struct Places {
  std::span<Word> words;
  std::uint32_t size = 0;
};

/// What a request is answered from. A view: it owns nothing.
struct Tables {
  Places<std::uint64_t> coils;
  Places<const std::uint64_t> discrete_inputs;
  Places<std::uint64_t> holding_registers;
  Places<const std::uint64_t> input_registers;
};

inline bool get_bit(std::span<const std::uint64_t> words, std::uint32_t place) noexcept {
  return (words[place / kBitsPerWord] >> (place % kBitsPerWord) & 1) != 0;
}

inline void set_bit(std::span<std::uint64_t> words, std::uint32_t place, bool on) noexcept {
  const std::uint64_t mask = std::uint64_t{1} << (place % kBitsPerWord);
  std::uint64_t& word = words[place / kBitsPerWord];
  word = on ? word | mask : word & ~mask;
}

/// The 64 bits from `place` on, the lowest address in the lowest bit; 0 behind the last word.
inline std::uint64_t get_bits(std::span<const std::uint64_t> words, std::uint32_t place) noexcept {
  const std::uint32_t word = place / kBitsPerWord;
  const std::uint32_t shift = place % kBitsPerWord;
  const std::uint64_t low = words[word] >> shift;
  if (shift == 0 || word + 1 >= words.size()) return low;
  return low | words[word + 1] << (kBitsPerWord - shift);
}

/// Sets the `count` bits from `place` on, at most 64, to the lowest ones of `bits`.
inline void set_bits(std::span<std::uint64_t> words, std::uint32_t place, std::uint64_t bits,
                     std::uint32_t count) noexcept {
  const std::uint32_t word = place / kBitsPerWord;
  const std::uint32_t shift = place % kBitsPerWord;
  const std::uint64_t mask = count == kBitsPerWord ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
  words[word] = (words[word] & ~(mask << shift)) | (bits & mask) << shift;
  if (shift + count <= kBitsPerWord) return;
  const std::uint32_t over = kBitsPerWord - shift;
  words[word + 1] = (words[word + 1] & ~(mask >> over)) | (bits & mask) >> over;
}

inline std::uint16_t get_register(std::span<const std::uint64_t> words, std::uint32_t place) noexcept {
  return static_cast<std::uint16_t>(words[place / kRegistersPerWord] >> (16 * (place % kRegistersPerWord)));
}

inline void set_register(std::span<std::uint64_t> words, std::uint32_t place, std::uint16_t value) noexcept {
  const std::uint32_t shift = 16 * (place % kRegistersPerWord);
  std::uint64_t& word = words[place / kRegistersPerWord];
  word = (word & ~(std::uint64_t{0xFFFF} << shift)) | (std::uint64_t{value} << shift);
}

}  // namespace symplant::link::modbus
