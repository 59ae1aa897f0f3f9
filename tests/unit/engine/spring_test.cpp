// The engine on units with a spring: spring return, reversing, stopping.
#include "support/catch.hpp"
#include "support/hand_plant.hpp"

namespace symplant::test {
namespace {

using tables::kMillisecond;
using tables::kSecond;

/// RET (0, rest) and ADV (1) with an operation; 1 s out, spring return takes the default travel.
HandUnit cylinder(tables::Time out = kSecond, tables::Time back = kSecond) {
  return {2, {1}, {{0, 1, 0, 0, out}}, tables::Actuation::spring, 0, 0, back};
}

TEST_CASE("A spring moves out under its command, stays while it is on, and returns without it") {
  HandPlant plant({cylinder()});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(1);
  plant.to(1 + kSecond);
  CHECK(plant.event(0, 1));
  plant.to(5 * kSecond);
  CHECK(plant.unit(0).state == 1);
  plant.set(0, 0, false);
  plant.to(6 * kSecond);
  CHECK_FALSE(plant.event(0, 1));
  CHECK(plant.unit(0).target == 0);
  plant.to(7 * kSecond);
  CHECK(plant.event(0, 0));
}

TEST_CASE("A spring that starts away from its rest returns automatically") {
  HandUnit unit = cylinder();
  unit.initial = 1;
  HandPlant plant({unit});
  plant.to(0);
  CHECK(plant.unit(0).moving);
  CHECK_FALSE(plant.event(0, 1));
  plant.to(kSecond);
  CHECK(plant.event(0, 0));
}

TEST_CASE("A command cleared midway reverses the move, in proportion") {
  HandPlant plant({cylinder(kSecond, 3 * kSecond)});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(0);
  plant.set(0, 0, false);
  plant.to(250 * kMillisecond);
  CHECK(plant.unit(0).target == 0);
  CHECK(plant.unit(0).remaining == 750 * kMillisecond);  // a quarter of three seconds
  plant.to(kSecond - 1);
  CHECK_FALSE(plant.event(0, 0));
  plant.to(kSecond);
  CHECK(plant.event(0, 0));
}

TEST_CASE("A reversed move can be reversed again") {
  HandPlant plant({cylinder()});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(0);
  plant.set(0, 0, false);
  plant.to(400 * kMillisecond);  // 0.4 of the distance out, now coming back
  plant.set(0, 0, true);
  plant.to(500 * kMillisecond);  // 0.3 of the distance out, now going out
  CHECK(plant.unit(0).target == 1);
  CHECK(plant.unit(0).remaining == 700 * kMillisecond);
  plant.to(1200 * kMillisecond);
  CHECK(plant.event(0, 1));
}

TEST_CASE("The time of a reversed move is rounded down") {
  HandPlant plant({cylinder(7, 5)});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(0);
  plant.set(0, 0, false);
  plant.to(3);
  CHECK(plant.unit(0).remaining == 2);  // floor(5 * 3 / 7)
}

TEST_CASE("Times of centuries are reversed without overflow") {
  const tables::Time long_time = tables::kNever / 2;
  HandPlant plant({cylinder(long_time, long_time)});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(0);
  plant.set(0, 0, false);
  plant.to(long_time / 2);
  CHECK(plant.unit(0).remaining == long_time / 2);
}

TEST_CASE("A move reversed in the instant of its start is back in that instant") {
  // Out and back are two operations here; the command back replaces the command out at once.
  const HandUnit unit{2, {0, 1}, {{1, 0, 0, 0, kSecond}, {0, 1, 1, 0, kSecond}}, tables::Actuation::spring, 0,
                      0, kSecond};
  HandPlant plant({unit});
  plant.to(0);
  plant.set(0, 1, true);
  plant.to(1);
  plant.set(0, 1, false);
  plant.to(1);  // another instant of the same time
  CHECK_FALSE(plant.unit(0).moving);
  CHECK(plant.event(0, 0));
}

TEST_CASE("Both commands together stop a spring and its time") {
  const HandUnit unit{2, {0, 1}, {{1, 0, 0, 0, kSecond}, {0, 1, 1, 0, kSecond}}, tables::Actuation::spring, 0,
                      0, kSecond};
  HandPlant plant({unit});
  plant.to(0);
  plant.set(0, 1, true);
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(300 * kMillisecond);
  plant.to(5 * kSecond);
  CHECK(plant.unit(0).moving);
  CHECK(plant.unit(0).remaining == 700 * kMillisecond);
  plant.set(0, 0, false);
  plant.to(6 * kSecond);
  plant.to(6700 * kMillisecond);
  CHECK(plant.event(0, 1));
}

TEST_CASE("A spring away from rest continues to its target when its command goes off during its move to rest") {
  // Three states: a move that does not start at rest completes without a command, then the spring returns.
  const HandUnit unit{3,
                      {1, 2},
                      {{0, 1, 0, 0, kSecond}, {0, 2, 1, 0, kSecond}, {1, 2, 1, 0, kSecond}, {2, 1, 0, 0, kSecond}},
                      tables::Actuation::spring,
                      0,
                      0,
                      kSecond};
  HandPlant plant({unit});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(0);
  plant.to(kSecond);
  REQUIRE(plant.unit(0).state == 1);
  plant.set(0, 0, false);
  plant.set(0, 1, true);
  plant.to(2 * kSecond);
  plant.set(0, 1, false);
  plant.to(2500 * kMillisecond);
  CHECK(plant.unit(0).target == 2);
  plant.to(3 * kSecond);
  CHECK(plant.unit(0).state == 2);
  CHECK(plant.unit(0).target == 0);
}

}  // namespace
}  // namespace symplant::test
