// The symbols that share an address with others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/engine/arena.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::engine {

/// A symbol's position, and that of the leader of all symbols on its address.
struct SharedPosition {
  std::uint32_t position;  ///< a bit, or kSharedSlot + a slot
  std::uint32_t leader;    ///< a bit, or kSharedSlot + a slot
};
inline constexpr std::uint32_t kSharedSlot = 0x8000'0000;

/// All symbols of one direction that share an address with others; empty in almost every plant.
class SharedPositions {
 public:
  void build(const tables::PlantTables& tables, tables::Direction direction, Arena& arena) noexcept;

  bool empty() const noexcept { return size_ == 0; }
  /// All positions with the same address as `position`, including itself; empty if it shares its address with no other.
  /// O(log shared symbols).
  std::span<const SharedPosition> with(std::uint32_t position) const noexcept;

 private:
  const SharedPosition* by_position_ = nullptr;
  const SharedPosition* by_leader_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace symplant::engine
