// Packs addresses into the fewest requests.
#include "symplant/link/modbus/client_plan.hpp"

namespace symplant::link::modbus {

// A range that begins at the first item not yet covered, and reaches as far as it can, is always part of a smallest
// plan.
std::vector<PlannedRange> plan_ranges(std::span<const AddressRange> items, std::uint32_t limit, bool over_gaps) {
  std::vector<PlannedRange> ranges;
  std::size_t before = 0;
  for (const AddressRange& item : items) {
    AddressRange* const last = ranges.empty() ? nullptr : &ranges.back().range;
    const bool joins = last != nullptr && item.end() - last->first <= limit && (over_gaps || item.first == last->end());
    if (joins) {
      last->count = item.end() - last->first;
    } else {
      ranges.push_back({item, before});
    }
    before += item.count;
  }
  return ranges;
}

}  // namespace symplant::link::modbus
