// A set of numbers that rounds visit in ascending order, while the visits mark further numbers.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "symplant/engine/arena.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::engine {

class RoundMarks {
 public:
  void take(Arena& arena, std::size_t numbers) noexcept {
    words_ = arena.take<std::uint64_t>((numbers + 63) / 64);
    size_ = static_cast<std::uint32_t>(numbers);
    begin_ = tables::kNone;
    end_ = count_ = 0;
  }
  void mark(std::uint32_t number) noexcept {
    std::uint64_t& word = words_[number / 64];
    const std::uint64_t bit = std::uint64_t{1} << (number % 64);
    if ((word & bit) != 0) return;
    word |= bit;
    ++count_;
    begin_ = std::min(begin_, number / 64);
    end_ = std::max(end_, number + 1);
  }
  void mark_all() noexcept {
    for (std::uint32_t number = 0; number < size_; ++number) mark(number);
  }
  bool empty() const noexcept { return count_ == 0; }
  void clear() noexcept {
    visit([](std::uint32_t) {});
  }
  /// Calls `function(number)` for each in ascending order. Of the numbers that it marks, greater ones are visited too;
  /// the others stay in the set for the next visit. O(words between the least and the greatest number).
  template <class Function>
  void visit(Function function) noexcept {
    if (count_ == 0) return;
    std::uint32_t number = begin_ * 64;
    begin_ = tables::kNone;
    while (number < end_) {
      const std::uint64_t bits = words_[number / 64] >> (number % 64);
      if (bits == 0) {
        number = (number / 64 + 1) * 64;
        continue;
      }
      number += static_cast<std::uint32_t>(std::countr_zero(bits));
      words_[number / 64] &= ~(std::uint64_t{1} << (number % 64));
      --count_;
      function(number);
      ++number;
    }
    if (count_ == 0) end_ = 0;
  }

 private:
  std::uint64_t* words_;
  std::uint32_t size_;
  std::uint32_t begin_;  ///< no number is in a word before it
  std::uint32_t end_;    ///< every number is less
  std::uint32_t count_;
};

}  // namespace symplant::engine
