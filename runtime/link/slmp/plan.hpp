// Packs words and bits of a PLC's memory into the fewest requests.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symplant/link/slmp/device.hpp"
#include "symplant/link/slmp/limits.hpp"

namespace symplant::link::slmp {

/// 16 bits of a PLC's memory: one word device, or the bit devices 16 * word to 16 * word + 15.
struct Cell {
  Kind kind = 0;
  std::uint32_t word = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
  friend bool operator<(const Cell& a, const Cell& b) { return a.kind != b.kind ? a.kind < b.kind : a.word < b.word; }
};

inline constexpr std::uint32_t kBitsInCell = 16;
inline constexpr std::uint16_t kWholeCell = 0xFFFF;  ///< a mask of its bits

/// A bit device.
struct Bit {
  Kind kind = 0;
  std::uint32_t number = 0;
  friend bool operator==(const Bit&, const Bit&) = default;
  friend bool operator<(const Bit& a, const Bit& b) { return a.kind != b.kind ? a.kind < b.kind : a.number < b.number; }
};

/// How a request names what it transfers.
enum class Access : std::uint8_t {
  batch,   ///< one span
  random,  ///< spans of one or two words, those of one first; or spans of one bit
  blocks,  ///< several spans, those of word devices first
};

/// Consecutive words, or bits, of one kind.
struct Span {
  Kind kind = 0;
  std::uint32_t first = 0;  ///< number of the first word or bit
  std::uint32_t count = 0;
  std::uint32_t item = 0;  ///< index of the first item in it, in the list that was planned
};

struct Transfer {
  Access access = Access::batch;
  std::vector<Span> spans;
};

/// Requests that read all cells; they may also read words between them. The cells ascend without duplicates.
///
/// Without block access the number of requests is the least possible for batch and random access, which may be mixed:
/// the best choice of batches is found by dynamic programming. With block access, blocks over gaps of several lengths
/// are tried, too, and the plan with the fewest requests is returned. O(cells * requests).
std::vector<Transfer> plan_reads(std::span<const Cell> cells, const Limits& limits);

/// Requests that write these cells and nothing else, as plan_reads().
std::vector<Transfer> plan_writes(std::span<const Cell> cells, const Limits& limits);

/// Requests that write these bits and nothing else, in units of bits. Timers are left out if there are no batches. The
/// bits ascend without duplicates.
std::vector<Transfer> plan_bit_writes(std::span<const Bit> bits, const Limits& limits);

}  // namespace symplant::link::slmp
