// Compares the radix wheel with a sorted map.
#include "symplant/engine/wheel.hpp"

#include <map>
#include <random>
#include <set>
#include <vector>

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using engine::Wheel;
using tables::kNever;
using tables::Time;

std::set<std::uint32_t> taken(Wheel& wheel, std::vector<engine::UnitState>& units, Time time) {
  std::set<std::uint32_t> result;
  for (std::uint32_t unit = wheel.take(time); unit != tables::kNone; unit = units[unit].next) {
    units[unit].flags = 0;
    result.insert(unit);
  }
  return result;
}

TEST_CASE("Units are returned at their exact times, all of one time together") {
  // Spans from nanoseconds to centuries, so that every group of six bits has entries.
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    std::mt19937_64 random(seed);
    Wheel wheel;
    wheel.clear();
    std::vector<engine::UnitState> units(500);
    std::map<Time, std::set<std::uint32_t>> expected;
    std::vector<Time> due(units.size(), kNever);
    Time now = 0;
    const auto insert = [&](std::uint32_t unit) {
      const Time distance = static_cast<Time>(random() >> (1 + random() % 62)) / 4;
      due[unit] = now + distance % (kNever / 2 - now / 2);
      wheel.insert(units.data(), unit, due[unit]);
      expected[due[unit]].insert(unit);
    };
    for (std::uint32_t unit = 0; unit < units.size(); ++unit) insert(unit);
    for (int step = 0; step < 20'000 && !expected.empty(); ++step) {
      REQUIRE(wheel.peek(units.data()) == expected.begin()->first);
      if (random() % 4 == 0) {  // remove one before its time
        const auto unit = static_cast<std::uint32_t>(random() % units.size());
        if (due[unit] != kNever) {
          wheel.remove(units.data(), unit);
          expected[due[unit]].erase(unit);
          if (expected[due[unit]].empty()) expected.erase(due[unit]);
          due[unit] = kNever;
        }
        continue;
      }
      // Time advances, sometimes to just before the next due time.
      const Time next = expected.begin()->first;
      const Time limit = random() % 3 == 0 ? now + (next - now) / 2 : next;
      const Time found = wheel.earliest(units.data(), limit);
      if (limit < next) {
        REQUIRE(found == kNever);
        now = limit;
      } else {
        REQUIRE(found == next);
        now = next;
        REQUIRE(taken(wheel, units, next) == expected.begin()->second);
        for (const std::uint32_t unit : expected.begin()->second) due[unit] = kNever;
        expected.erase(expected.begin());
      }
      for (std::uint32_t unit = 0; unit < units.size() && random() % 8 != 0; ++unit) {
        if (due[unit] == kNever && now < kNever / 4) {
          insert(unit);
          break;
        }
      }
    }
  }
}

TEST_CASE("An empty wheel has nothing due") {
  Wheel wheel;
  wheel.clear();
  std::vector<engine::UnitState> units(1);
  CHECK(wheel.earliest(units.data(), kNever) == kNever);
  CHECK(wheel.peek(units.data()) == kNever);
}

}  // namespace
}  // namespace symplant::test
