// In real time: finds events that rise and fall within one cycle, which a PLC may miss.
#pragma once

#include <cstddef>
#include <cstdint>

#include "symplant/engine/arena.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {

/// Stores rises; those of one instant in one word of the plane are one entry. It lies in the flat block. If one cycle
/// has more rises than its capacity (at least 64, and one for every word), the oldest are dropped.
class ShortEvents {
 public:
  void take(Arena& arena, std::size_t words) noexcept;
  void rose(std::uint32_t word, std::uint64_t bits, tables::Time now) noexcept;
  /// `bits` fall now; returns those that rose less than `cycle` ago. O(rises of that word within a cycle).
  std::uint64_t fell(std::uint32_t word, std::uint64_t bits, tables::Time now, tables::Time cycle) noexcept;
  /// Forgets all rises so far. O(1).
  void forget() noexcept { count_[1] = count_[0]; }

 private:
  struct Rise {
    tables::Time time;
    std::uint64_t bits;
    std::uint32_t before;  ///< number of the previous rise of the same word, + 1; 0 if there is no such rise
    std::uint32_t word;
  };

  Rise* rises_;
  std::uint32_t* last_;     ///< of each word: number of its last rise, + 1; 0 if there is no such rise
  std::uint32_t* count_;    ///< number of rises so far, and of those that are forgotten
  std::uint32_t capacity_;  ///< a power of two
};

}  // namespace symplant::engine
