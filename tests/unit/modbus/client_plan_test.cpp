// Packing addresses into requests.
#include "symplant/link/modbus/client_plan.hpp"

#include <algorithm>
#include <random>

#include "support/catch.hpp"
#include "unit/modbus/draw.hpp"

using namespace symplant::link::modbus;
using symplant::test::draw;

namespace {

std::vector<AddressRange> ranges_of(const std::vector<AddressRange>& items, std::uint32_t limit, bool over_gaps) {
  std::vector<AddressRange> ranges;
  for (const PlannedRange& planned : plan_ranges(items, limit, over_gaps)) ranges.push_back(planned.range);
  return ranges;
}

/// Items of one to four addresses, dense or scattered.
std::vector<AddressRange> random_items(std::mt19937& random) {
  std::vector<AddressRange> items;
  const std::uint32_t spread = 1U << draw(random, 12);
  std::uint32_t at = draw(random, 1000);
  const std::size_t count = draw(random, 200);
  while (items.size() < count) {
    at += draw(random, 3) == 0 ? draw(random, spread) : 0;
    const std::uint32_t width = 1U << draw(random, 3);
    if (at + width > 65'536) break;
    items.push_back({at, width});
    at += width;
  }
  return items;
}

/// The fewest ranges, by trying all lengths of the first one.
std::size_t fewest(const std::vector<AddressRange>& items, std::uint32_t limit, bool over_gaps) {
  std::vector<std::size_t> needed(items.size() + 1);
  for (std::size_t first = items.size(); first-- > 0;) {
    needed[first] = items.size();
    for (std::size_t last = first; last < items.size(); ++last) {
      if (items[last].end() - items[first].first > limit) break;
      if (!over_gaps && last > first && items[last].first != items[last - 1].end()) break;
      needed[first] = std::min(needed[first], 1 + needed[last + 1]);
    }
  }
  return needed[0];
}

}  // namespace

TEST_CASE("Ranges reach over gaps only if they may") {
  const std::vector<AddressRange> items = {{1, 1}, {2, 1}, {10, 2}};
  CHECK(ranges_of(items, 100, true) == std::vector<AddressRange>{{1, 11}});
  CHECK(ranges_of(items, 100, false) == std::vector<AddressRange>{{1, 2}, {10, 2}});
  CHECK(ranges_of({}, 100, true).empty());
}

TEST_CASE("A number of several registers is not divided at a limit") {
  const std::vector<AddressRange> items = {{0, 4}, {4, 4}, {8, 2}};
  CHECK(ranges_of(items, 7, true) == std::vector<AddressRange>{{0, 4}, {4, 6}});
}

TEST_CASE("Every plan keeps the limit, covers each item whole and once, and is the smallest") {
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    const auto items = random_items(random);
    const std::uint32_t limit = 4 + draw(random, 130);
    const bool over_gaps = draw(random, 2) == 0;
    CAPTURE(i, limit, over_gaps, items.size());
    const auto planned = plan_ranges(items, limit, over_gaps);
    CHECK(planned.size() == fewest(items, limit, over_gaps));
    std::size_t next = 0;
    std::size_t before = 0;
    for (const PlannedRange& one : planned) {
      CHECK(one.range.count <= limit);
      CHECK(one.item == before);
      std::uint32_t covered = 0;
      for (; next < items.size() && items[next].end() <= one.range.end(); ++next) {
        CHECK(items[next].first >= one.range.first);
        covered += items[next].count;
      }
      before += covered;
      if (!over_gaps) CHECK(covered == one.range.count);
    }
    CHECK(next == items.size());
  }
}
