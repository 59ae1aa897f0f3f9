// In real time: which events rose less than a cycle ago, so that a fall now is one that a PLC may miss.
#pragma once

#include <cstddef>
#include <cstdint>

#include "symplant/engine/arena.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {

/// Remembers rises, those of one instant in one word of the plane together. It lies in the flat block. Where more
/// happen within one cycle than it has room for (64, or a rise in every word), the oldest are forgotten.
class ShortEvents {
 public:
  void take(Arena& arena, std::size_t words) noexcept;
  void rose(std::uint32_t word, std::uint64_t bits, tables::Time now) noexcept;
  /// Those of `bits`, which fall now, that rose less than `cycle` ago. O(rises of that word within a cycle).
  std::uint64_t fell(std::uint32_t word, std::uint64_t bits, tables::Time now, tables::Time cycle) noexcept;

 private:
  struct Rise {
    tables::Time time;
    std::uint64_t bits;
    std::uint32_t before;  ///< number of the rise of the same word before, + 1
    std::uint32_t word;
  };

  Rise* rises_;
  std::uint32_t* last_;     ///< a word: number of its last rise, + 1
  std::uint32_t* count_;    ///< rises so far
  std::uint32_t capacity_;  ///< a power of two
};

}  // namespace symplant::engine
