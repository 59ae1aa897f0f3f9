// Faster and slower plants.
#include "suite/plants.hpp"

#include "support/catch.hpp"

namespace symplant::suite {
namespace {

lower::EngineTables some_tables() {
  lower::EngineTables tables;
  tables.random_times = {{tables::RandomTime::Kind::uniform, 100, 200}};
  lower::Type type{};
  type.times = {{50, 1000}, {-1, -1}, {0, 0}, {0, 3}};
  tables.types.push_back(type);
  tables.times = {{0, -1}, {7, 10}};
  return tables;
}

TEST_CASE("Every travel time is a fifth or three times as long, and delays stay") {
  const lower::EngineTables fast = at_speed(some_tables(), Speed::fast);
  CHECK(fast.types[0].times[0].after == 50);
  CHECK(fast.types[0].times[0].takes == 200);
  CHECK(fast.types[0].times[2].takes == 0);
  CHECK(fast.types[0].times[3].takes == 1);  // not none at all
  CHECK(fast.times[1].takes == 2);
  const lower::EngineTables slow = at_speed(some_tables(), Speed::slow);
  CHECK(slow.types[0].times[0].takes == 3000);
  CHECK(slow.times[1].takes == 30);
  CHECK(slow.times[1].after == 7);
  CHECK(at_speed(some_tables(), Speed::normal).times[1].takes == 10);
}

TEST_CASE("The engine gets the changed times") {
  const lower::EngineTables slow = at_speed(some_tables(), Speed::slow);
  CHECK(slow.tables().types[0].times[0].takes == 3000);
  CHECK(slow.tables().times[1].takes == 30);
}

TEST_CASE("A random travel time is scaled apart from a delay that has the same one") {
  const lower::EngineTables slow = at_speed(some_tables(), Speed::slow);
  REQUIRE(slow.random_times.size() == 2);
  CHECK(slow.random_times[0].a == 100);
  CHECK(slow.random_times[1].a == 300);
  CHECK(slow.random_times[1].b == 600);
  CHECK(slow.types[0].times[1].after == -1);
  CHECK(slow.types[0].times[1].takes == -2);
  CHECK(slow.times[0].takes == -2);
}

}  // namespace
}  // namespace symplant::suite
