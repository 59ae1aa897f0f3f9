// Allocates bits of the planes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "symplant/tables/tables.hpp"

namespace symplant::lower {

/// Allocates bits of a plane so that the bits of a unit are in one word.
class BitPlane {
 public:
  std::uint32_t take(std::size_t count) {
    if (used_ % 64 + count > 64) next_word();
    const auto first = static_cast<std::uint32_t>(used_);
    used_ += count;
    return first;
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>((used_ + 63) / 64 * 64); }
  /// Whether the next bit begins a word.
  bool at_word() const { return used_ % 64 == 0; }
  void next_word() { used_ = (used_ + 63) / 64 * 64; }

 private:
  std::size_t used_ = 0;
};

/// The plane of operations. The units in a word are also near each other (tables::kMaxUnitsInWord).
class OperationPlane : public BitPlane {
 public:
  /// Call in the order of units.
  std::uint32_t take_for(std::uint32_t unit, std::size_t count) {
    if (count == 0) return take(0);
    if (!at_word() && unit - first_in_word_ >= tables::kMaxUnitsInWord) next_word();
    const std::uint32_t first = take(count);
    if (first / 64 != word_) {
      word_ = first / 64;
      first_in_word_ = unit;
    }
    return first;
  }

 private:
  std::uint32_t word_ = 0xFFFF'FFFF;
  std::uint32_t first_in_word_ = 0;
};

}  // namespace symplant::lower
