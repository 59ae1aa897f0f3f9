// A set of numbers that is visited in ascending order.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "symplant/engine/arena.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::engine {

/// One bit per number, and the range of words with marks: a visit of all numbers costs O(words in the range).
class MarkRange {
 public:
  void take(Arena& arena, std::size_t numbers) noexcept {
    words_ = arena.take<std::uint64_t>((numbers + 63) / 64);
    begin_ = tables::kNone;
    end_ = 0;
  }
  void mark(std::uint32_t number) noexcept {
    words_[number / 64] |= std::uint64_t{1} << (number % 64);
    begin_ = std::min(begin_, number / 64);
    end_ = std::max(end_, number / 64 + 1);
  }
  /// Calls `function(number, is_last)` for each in ascending order; the set is empty afterwards.
  template <class Function>
  void take_all(Function function) noexcept {
    const std::uint32_t end = end_;
    for (std::uint32_t word = begin_; word < end; ++word) {
      for (std::uint64_t bits = words_[word]; bits != 0; bits &= bits - 1) {
        const bool last = word + 1 == end && (bits & (bits - 1)) == 0;
        function(word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits)), last);
      }
      words_[word] = 0;
    }
    begin_ = tables::kNone;
    end_ = 0;
  }

 private:
  std::uint64_t* words_;
  std::uint32_t begin_;  ///< first word that may have a mark
  std::uint32_t end_;
};

}  // namespace symplant::engine
