// A bit plane as links and traces see it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

namespace symplant::engine {

/// A plane as units see it, and its inverted bits.
struct PlaneWords {
  const std::uint64_t* levels;
  const std::uint64_t* inverted;
  std::size_t size;
};

/// The words of a plane, in which inverted symbols have the opposite bit of what their units see. It refers to the
/// plant. Every member O(1).
class BitWords {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = std::uint64_t;
    using difference_type = std::ptrdiff_t;
    using pointer = const std::uint64_t*;
    using reference = std::uint64_t;

    Iterator(const std::uint64_t* level, const std::uint64_t* inverted) noexcept : level_(level), inverted_(inverted) {}
    std::uint64_t operator*() const noexcept { return *level_ ^ *inverted_; }
    Iterator& operator++() noexcept {
      ++level_;
      ++inverted_;
      return *this;
    }
    Iterator operator++(int) noexcept {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    friend std::ptrdiff_t operator-(const Iterator& a, const Iterator& b) noexcept { return a.level_ - b.level_; }
    friend bool operator==(const Iterator& a, const Iterator& b) noexcept { return a.level_ == b.level_; }

   private:
    const std::uint64_t* level_;
    const std::uint64_t* inverted_;
  };

  explicit BitWords(const PlaneWords& plane) noexcept : plane_(&plane) {}

  std::uint64_t operator[](std::size_t word) const noexcept { return plane_->levels[word] ^ plane_->inverted[word]; }
  std::size_t size() const noexcept { return plane_->size; }
  Iterator begin() const noexcept { return {plane_->levels, plane_->inverted}; }
  Iterator end() const noexcept { return {plane_->levels + plane_->size, plane_->inverted + plane_->size}; }

 private:
  const PlaneWords* plane_;
};

}  // namespace symplant::engine
