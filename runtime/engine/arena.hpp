// Cuts arrays out of one piece of memory; without memory it only counts what it would need.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace symplant::engine {

class Arena {
 public:
  /// `memory` null: every array is empty and only used() means something.
  explicit Arena(std::byte* memory) noexcept : memory_(memory) {}

  /// An array of `count` zeroed objects of a type for which all bits zero is a value.
  template <class T>
  T* take(std::size_t count) noexcept {
    return static_cast<T*>(take_bytes(count * sizeof(T), alignof(T)));
  }

  std::size_t used() const noexcept { return used_; }

 private:
  void* take_bytes(std::size_t bytes, std::size_t alignment) noexcept;

  std::byte* memory_;
  std::size_t used_ = 0;
};

}  // namespace symplant::engine
