// The events that changed more than once since the link last forgot their changes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/dirty_set.hpp"

namespace symplant::engine {

class Pulses {
 public:
  void take(Arena& arena, std::size_t words) noexcept {
    once_ = arena.take<std::uint64_t>(words);
    more_ = arena.take<std::uint64_t>(words);
    changed_.take(arena, words);
  }

  /// `bits` of a word changed in an instant, at its end.
  void changed(std::uint32_t word, std::uint64_t bits) noexcept {
    if (once_[word] == 0) changed_.add(word);
    more_[word] |= once_[word] & bits;
    once_[word] |= bits;
  }
  std::uint64_t of_word(std::uint32_t word) const noexcept { return more_[word]; }
  /// O(changed words).
  void forget() noexcept {
    for (const std::uint32_t word : changed_.view()) once_[word] = more_[word] = 0;
    changed_.size = 0;
  }

 private:
  std::uint64_t* once_;
  std::uint64_t* more_;
  List<std::uint32_t> changed_;
};

}  // namespace symplant::engine
