// Stores the rises of events within the last cycle.
#include "symplant/engine/short_events.hpp"

#include <algorithm>
#include <bit>

namespace symplant::engine {

void ShortEvents::take(Arena& arena, std::size_t words) noexcept {
  capacity_ = static_cast<std::uint32_t>(std::bit_ceil(std::max<std::size_t>(64, words)));
  rises_ = arena.take<Rise>(words == 0 ? 0 : capacity_);
  last_ = arena.take<std::uint32_t>(words);
  count_ = arena.take<std::uint32_t>(2);
}

void ShortEvents::rose(std::uint32_t word, std::uint64_t bits, tables::Time now) noexcept {
  const std::uint32_t number = count_[0]++;
  rises_[number % capacity_] = {now, bits, last_[word], word};
  last_[word] = number + 1;
}

std::uint64_t ShortEvents::fell(std::uint32_t word, std::uint64_t bits, tables::Time now, tables::Time cycle) noexcept {
  std::uint64_t found = 0;
  for (std::uint32_t number = last_[word]; number != 0 && bits != 0;) {
    const std::uint32_t age = count_[0] - (number - 1);  // 1: the last one
    const Rise& rise = rises_[(number - 1) % capacity_];
    const bool forgotten = age > count_[0] - count_[1];
    if (age > capacity_ || forgotten || rise.word != word || now - rise.time >= cycle) break;
    found |= bits & rise.bits;
    bits &= ~rise.bits;  // an older rise of the same event is not this one
    number = rise.before;
  }
  return found;
}

}  // namespace symplant::engine
