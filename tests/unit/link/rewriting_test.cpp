// What a PLC has written, and whether it has written all of it again.
#include "symplant/link/image/rewriting.hpp"

#include <random>
#include <set>

#include "support/catch.hpp"

using symplant::link::image::PositionSet;
using symplant::link::image::Rewriting;

TEST_CASE("A set of addresses contains the added ranges, wherever they begin and end") {
  std::mt19937 dice(7);
  const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(dice() % end); };
  PositionSet set(300);
  std::set<std::uint32_t> expected;
  for (int i = 0; i < 500; ++i) {
    const std::uint32_t first = below(300);
    const std::uint32_t count = below(301 - first);
    std::uint32_t there = 0;
    for (std::uint32_t p = first; p < first + count; ++p) there += static_cast<std::uint32_t>(expected.count(p));
    REQUIRE(set.has_any(first, count) == (there != 0));
    if (below(2) == 0) {
      set.add(first, count);
      for (std::uint32_t p = first; p < first + count; ++p) expected.insert(p);
    } else {
      REQUIRE(set.remove(first, count) == there);
      for (std::uint32_t p = first; p < first + count; ++p) expected.erase(p);
    }
    REQUIRE(set.size() == expected.size());
  }
}

namespace {

/// Every address has a symbol.
PositionSet all() {
  PositionSet set(200);
  set.add(0, 200);
  return set;
}

}  // namespace

TEST_CASE("Addresses without a symbol are not awaited") {
  Rewriting writes(200, 200);
  writes.wrote(true, 0, 10);
  PositionSet mapped(200);
  mapped.add(3, 1);
  writes.begin(mapped, mapped);
  CHECK_FALSE(writes.complete());
  writes.wrote(true, 3, 1);
  CHECK(writes.complete());
}

TEST_CASE("Before a loss nothing is awaited") {
  Rewriting writes(200, 200);
  CHECK(writes.complete());
  writes.wrote(true, 3, 10);
  CHECK(writes.complete());
}

TEST_CASE("After a loss all earlier writes are awaited, in both tables, in any order and split") {
  Rewriting writes(200, 200);
  writes.wrote(true, 60, 10);
  writes.wrote(false, 5, 1);
  writes.begin(all(), all());
  CHECK_FALSE(writes.complete());
  writes.wrote(true, 0, 65);
  CHECK_FALSE(writes.complete());
  writes.wrote(false, 5, 1);
  CHECK_FALSE(writes.complete());
  writes.wrote(true, 65, 5);
  CHECK(writes.complete());
}

TEST_CASE("An address that is written twice counts once, and the other table does not count") {
  Rewriting writes(200, 200);
  writes.wrote(true, 1, 2);
  writes.begin(all(), all());
  writes.wrote(true, 1, 1);
  writes.wrote(true, 1, 1);
  writes.wrote(false, 2, 1);
  CHECK_FALSE(writes.complete());
  writes.wrote(true, 2, 1);
  CHECK(writes.complete());
}

TEST_CASE("After a loss a PLC that never wrote has nothing to rewrite, after a second loss all again") {
  Rewriting writes(200, 200);
  writes.begin(all(), all());
  CHECK(writes.complete());
  writes.wrote(true, 0, 1);
  writes.begin(all(), all());
  CHECK_FALSE(writes.complete());
  writes.wrote(true, 0, 1);
  CHECK(writes.complete());
  writes.begin(all(), all());
  CHECK_FALSE(writes.complete());
}
