// A bit plane as links and traces see it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

namespace symplant::engine {

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

  BitWords(const std::uint64_t* levels, const std::uint64_t* inverted, std::size_t size) noexcept
      : levels_(levels), inverted_(inverted), size_(size) {}

  std::uint64_t operator[](std::size_t word) const noexcept { return levels_[word] ^ inverted_[word]; }
  std::size_t size() const noexcept { return size_; }
  Iterator begin() const noexcept { return {levels_, inverted_}; }
  Iterator end() const noexcept { return {levels_ + size_, inverted_ + size_}; }

 private:
  const std::uint64_t* levels_;
  const std::uint64_t* inverted_;
  std::size_t size_;
};

}  // namespace symplant::engine
