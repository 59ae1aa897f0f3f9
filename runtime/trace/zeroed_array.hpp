// An array that takes memory only where it is written to.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace symplant::trace {

/// All bytes are zero at first. The system provides the pages of a large array when they are first written to, so room
/// that a run never needs costs nothing. Only the constructor allocates, and may throw std::bad_alloc. O(1).
template <class Item>
class ZeroedArray {
  static_assert(std::is_trivially_copyable_v<Item> && std::is_trivially_destructible_v<Item>);

 public:
  explicit ZeroedArray(std::size_t size)
      : size_(size), items_(static_cast<Item*>(std::calloc(size + 1, sizeof(Item)))) {
    if (items_ == nullptr) throw std::bad_alloc();
  }

  std::size_t size() const noexcept { return size_; }
  Item* begin() noexcept { return items_.get(); }
  Item& operator[](std::size_t index) noexcept { return items_[index]; }
  const Item& operator[](std::size_t index) const noexcept { return items_[index]; }

 private:
  struct Free {
    void operator()(Item* items) const noexcept { std::free(items); }
  };
  std::size_t size_;
  std::unique_ptr<Item[], Free> items_;
};

}  // namespace symplant::trace
