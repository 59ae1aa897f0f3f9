// A ring of findings not yet read, with a count of those lost when it was full.
#pragma once

#include <cstddef>
#include <cstdint>

#include "symplant/engine/arena.hpp"
#include "symplant/tables/finding.hpp"

namespace symplant::engine {

class FindingRing {
 public:
  static constexpr std::uint32_t kCapacity = 512;

  void take(Arena& arena) noexcept {
    items_ = arena.take<tables::Finding>(kCapacity);
    clear();
  }
  void clear() noexcept { first_ = size_ = lost_ = 0; }
  /// If the ring is full the new finding is counted as lost; older findings stay.
  void add(const tables::Finding& finding) noexcept {
    if (size_ == kCapacity) {
      ++lost_;
      items_[(first_ + size_ - 1) % kCapacity].more = false;  // the rest of its loop is lost
    } else {
      items_[(first_ + size_++) % kCapacity] = finding;
    }
  }
  bool pop(tables::Finding& finding) noexcept {
    if (size_ == 0) return false;
    finding = items_[first_ % kCapacity];
    ++first_;
    --size_;
    return true;
  }
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  tables::Finding* items_;
  std::uint64_t first_;
  std::uint64_t size_;
  std::uint64_t lost_;
};

}  // namespace symplant::engine
