// Packs addresses into the fewest requests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace symplant::link::modbus {

/// Consecutive addresses of one area.
struct AddressRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  std::uint32_t end() const noexcept { return first + count; }
  friend bool operator==(const AddressRange&, const AddressRange&) = default;
};

struct PlannedRange {
  AddressRange range;
  std::size_t item = 0;  ///< number of addresses in the items before it
};

/// The fewest ranges of at most `limit` addresses that contain each item whole: a number of several registers is never
/// divided. Items ascend without overlap, and none exceeds the limit. Without `over_gaps` a range has no address
/// outside of the items. O(items).
std::vector<PlannedRange> plan_ranges(std::span<const AddressRange> items, std::uint32_t limit, bool over_gaps);

}  // namespace symplant::link::modbus
