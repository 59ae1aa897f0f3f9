// A set of positions, changed and queried by ranges.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace symplant::link::image {

/// Calls `visit(word, mask)` for each word of a bit plane that has some of `count` bits from bit `first` on.
template <class Visit>
void for_words(std::uint32_t first, std::uint32_t count, Visit visit) noexcept {
  constexpr std::uint32_t kBits = 64;
  const std::uint32_t end = first + count;
  while (first < end) {
    const std::uint32_t low = first % kBits;
    const std::uint32_t bits = kBits - low < end - first ? kBits - low : end - first;
    visit(std::size_t{first / kBits}, (~std::uint64_t{0} >> (kBits - bits)) << low);
    first += bits;
  }
}

/// A set of positions below a size. Only the constructor allocates; a range costs one step for each 64 positions.
class PositionSet {
 public:
  explicit PositionSet(std::uint32_t size = 0) : words_((size + 63) / 64) {}

  void add(std::uint32_t first, std::uint32_t count) noexcept {
    for_words(first, count, [this](std::size_t word, std::uint64_t mask) { words_[word] |= mask; });
  }
  /// Returns the number of removed positions.
  std::uint32_t remove(std::uint32_t first, std::uint32_t count) noexcept {
    std::uint32_t removed = 0;
    for_words(first, count, [&](std::size_t word, std::uint64_t mask) {
      removed += static_cast<std::uint32_t>(std::popcount(words_[word] & mask));
      words_[word] &= ~mask;
    });
    return removed;
  }
  std::uint32_t count(std::uint32_t first, std::uint32_t count) const noexcept {
    std::uint32_t there = 0;
    for_words(first, count, [&](std::size_t word, std::uint64_t mask) {
      there += static_cast<std::uint32_t>(std::popcount(words_[word] & mask));
    });
    return there;
  }
  bool has_any(std::uint32_t first, std::uint32_t count) const noexcept {
    bool any = false;
    for_words(first, count, [&](std::size_t word, std::uint64_t mask) { any = any || (words_[word] & mask) != 0; });
    return any;
  }
  std::uint32_t size() const noexcept {
    std::uint32_t size = 0;
    for (const std::uint64_t word : words_) size += static_cast<std::uint32_t>(std::popcount(word));
    return size;
  }
  /// Becomes the intersection of two sets of the same size.
  void assign_common(const PositionSet& one, const PositionSet& other) noexcept {
    for (std::size_t word = 0; word < words_.size(); ++word) words_[word] = one.words_[word] & other.words_[word];
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace symplant::link::image
