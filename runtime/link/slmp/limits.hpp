// What one SLMP request may hold (SH-080008, appendix 5; JY997D56001 for FX5).
#pragma once

#include <cstdint>

#include "symplant/link/slmp/framing.hpp"

namespace symplant::link::slmp {

struct Limits {
  std::uint32_t words = 960;          ///< words in a row, read or written
  std::uint32_t bits = 7168;          ///< bits in a row, written in units of bits; 0: not possible
  std::uint32_t random_reads = 192;   ///< words and double words together
  std::uint32_t random_write = 1920;  ///< kRandomWord for each word, kRandomDouble for each double word
  std::uint32_t random_bits = 188;
  std::uint32_t blocks = 0;          ///< 0: no block access
  std::uint32_t block_points = 960;  ///< in all blocks of a request; written blocks count `block_cost` more each
  std::uint32_t block_cost = 4;
};

inline constexpr std::uint32_t kRandomWord = 12;
inline constexpr std::uint32_t kRandomDouble = 14;

/// The limits of a family; O(1).
constexpr Limits limits_of(const Framing& framing) noexcept {
  Limits limits;
  const bool ascii = framing.code == Code::ascii;
  if (framing.family == Family::fx5) {
    limits.words = ascii ? 480 : 960;
    limits.bits = ascii ? 1792 : 3584;
  } else if (ascii) {
    limits.bits = 3584;
  }
  const bool iqr = framing.commands == Commands::iqr;
  if (iqr) {
    limits.random_reads = 96;
    limits.random_write = 960;
    limits.random_bits = 94;
    limits.block_cost = 9;
  }
  // The Ethernet ports of Q and L CPUs reject block access with C059.
  if (framing.family == Family::iqr || framing.family == Family::fx5) limits.blocks = iqr ? 60 : 120;
  return limits;
}

}  // namespace symplant::link::slmp
