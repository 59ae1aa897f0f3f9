// Allocates arrays from one block of memory.
#include "symplant/engine/arena.hpp"

#include <cstring>

namespace symplant::engine {

void* Arena::take_bytes(std::size_t bytes, std::size_t alignment) noexcept {
  used_ = (used_ + alignment - 1) / alignment * alignment;
  const std::size_t begin = used_;
  used_ += bytes;
  if (memory_ == nullptr) return nullptr;
  return std::memset(memory_ + begin, 0, bytes);
}

}  // namespace symplant::engine
