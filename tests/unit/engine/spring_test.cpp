// The engine on units with a spring: the way without a command, turning round, standing still.
#include "support/catch.hpp"
#include "support/hand_plant.hpp"

namespace symplant::test {
namespace {

using tables::kMillisecond;
using tables::kSecond;

/// RET (0, rest) and ADV (1) with an operation; a second out, the spring's way takes the default travel.
HandUnit cylinder(tables::Time out = kSecond, tables::Time back = kSecond) {
  return {2, {1}, {{0, 1, 0, 0, out}}, tables::Actuation::spring, 0, 0, back};
}

TEST_CASE("a spring moves out under its command, stays while it is on, and returns without it") {
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

TEST_CASE("a spring that starts away from its rest returns by itself") {
  HandUnit unit = cylinder();
  unit.initial = 1;
  HandPlant plant({unit});
  plant.to(0);
  CHECK(plant.unit(0).moving);
  CHECK_FALSE(plant.event(0, 1));
  plant.to(kSecond);
  CHECK(plant.event(0, 0));
}

TEST_CASE("a command taken back midway turns the move round, in proportion") {
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

TEST_CASE("a move that was turned can be turned again") {
  HandPlant plant({cylinder()});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(0);
  plant.set(0, 0, false);
  plant.to(400 * kMillisecond);  // 0.4 of the way out, now coming back
  plant.set(0, 0, true);
  plant.to(500 * kMillisecond);  // 0.3 of the way out, now going out
  CHECK(plant.unit(0).target == 1);
  CHECK(plant.unit(0).remaining == 700 * kMillisecond);
  plant.to(1200 * kMillisecond);
  CHECK(plant.event(0, 1));
}

TEST_CASE("the time of a turned move is rounded down") {
  HandPlant plant({cylinder(7, 5)});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(0);
  plant.set(0, 0, false);
  plant.to(3);
  CHECK(plant.unit(0).remaining == 2);  // floor(5 * 3 / 7)
}

TEST_CASE("times of centuries turn round without overflow") {
  const tables::Time long_time = tables::kNever / 2;
  HandPlant plant({cylinder(long_time, long_time)});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(0);
  plant.set(0, 0, false);
  plant.to(long_time / 2);
  CHECK(plant.unit(0).remaining == long_time / 2);
}

TEST_CASE("a move turned in the instant in which it began is back in that instant") {
  // Out and back are two operations here; the command out gives way to the one back at once.
  const HandUnit unit{2, {0, 1}, {{1, 0, 0, 0, kSecond}, {0, 1, 1, 0, kSecond}}, tables::Actuation::spring, 0,
                      0, kSecond};
  HandPlant plant({unit});
  plant.to(0);
  plant.set(0, 1, true);
  plant.to(1);
  plant.set(0, 1, false);
  plant.to(1);  // a further instant of the same time
  CHECK_FALSE(plant.unit(0).moving);
  CHECK(plant.event(0, 0));
}

TEST_CASE("both commands at once make a spring stand still, and its time with it") {
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

TEST_CASE("a spring away from rest goes on to its target when its command goes off on the way to rest") {
  // Three states: a move that does not begin at rest completes without a command, then the spring returns.
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
