// The four tables of a Modbus server as plain memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/link/io_map.hpp"

namespace symplant::link::image {

inline constexpr std::uint32_t kBitsPerWord = 64;
inline constexpr std::uint32_t kRegistersPerWord = 4;

/// Number of words for `count` bits: 64 in a word, the lowest address in the lowest bit.
constexpr std::size_t bit_words(std::uint32_t count) { return (count + kBitsPerWord - 1) / kBitsPerWord; }
/// Number of words for `count` registers: four in a word, the lowest address in the lowest 16 bits.
constexpr std::size_t register_words(std::uint32_t count) {
  return (count + kRegistersPerWord - 1) / kRegistersPerWord;
}

/// The words of one table and its number of addresses; there is a word for every address.
template <class Word>
struct TableView {
  std::span<Word> words;
  std::uint32_t size = 0;
};

/// The tables that requests are answered from. A view: it owns nothing.
struct Tables {
  TableView<std::uint64_t> coils;
  TableView<const std::uint64_t> discrete_inputs;
  TableView<std::uint64_t> holding_registers;
  TableView<const std::uint64_t> input_registers;
};

inline bool get_bit(std::span<const std::uint64_t> words, std::uint32_t address) noexcept {
  return (words[address / kBitsPerWord] >> (address % kBitsPerWord) & 1) != 0;
}

inline void set_bit(std::span<std::uint64_t> words, std::uint32_t address, bool on) noexcept {
  const std::uint64_t mask = std::uint64_t{1} << (address % kBitsPerWord);
  std::uint64_t& word = words[address / kBitsPerWord];
  word = on ? word | mask : word & ~mask;
}

/// The 64 bits from `address` on, the lowest address in the lowest bit; 0 after the last word.
inline std::uint64_t get_bits(std::span<const std::uint64_t> words, std::uint32_t address) noexcept {
  const std::uint32_t word = address / kBitsPerWord;
  const std::uint32_t shift = address % kBitsPerWord;
  const std::uint64_t low = words[word] >> shift;
  if (shift == 0 || word + 1 >= words.size()) return low;
  return low | words[word + 1] << (kBitsPerWord - shift);
}

/// Sets `count` bits (at most 64) from `address` on to the lowest ones of `bits`.
inline void set_bits(std::span<std::uint64_t> words, std::uint32_t address, std::uint64_t bits,
                     std::uint32_t count) noexcept {
  const std::uint32_t word = address / kBitsPerWord;
  const std::uint32_t shift = address % kBitsPerWord;
  const std::uint64_t mask = count == kBitsPerWord ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
  words[word] = (words[word] & ~(mask << shift)) | (bits & mask) << shift;
  if (shift + count <= kBitsPerWord) return;
  const std::uint32_t over = kBitsPerWord - shift;
  words[word + 1] = (words[word + 1] & ~(mask >> over)) | (bits & mask) >> over;
}

inline std::uint16_t get_register(std::span<const std::uint64_t> words, std::uint32_t address) noexcept {
  return static_cast<std::uint16_t>(words[address / kRegistersPerWord] >> (16 * (address % kRegistersPerWord)));
}

inline void set_register(std::span<std::uint64_t> words, std::uint32_t address, std::uint16_t value) noexcept {
  const std::uint32_t shift = 16 * (address % kRegistersPerWord);
  std::uint64_t& word = words[address / kRegistersPerWord];
  word = (word & ~(std::uint64_t{0xFFFF} << shift)) | (std::uint64_t{value} << shift);
}

}  // namespace symplant::link::image
