// Allocates arrays from one block of memory; without memory it only counts the bytes needed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace symplant::engine {

class Arena {
 public:
  /// If `memory` is null, take() returns null and only used() is valid.
  explicit Arena(std::byte* memory) noexcept : memory_(memory) {}

  /// An array of `count` zeroed objects; all bits zero must be a valid T. The caller ensures that the memory suffices.
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
