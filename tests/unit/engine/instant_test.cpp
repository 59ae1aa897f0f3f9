// Instants: what belongs to one, and what an observer receives.
#include <algorithm>

#include "support/catch.hpp"
#include "support/hand_plant.hpp"

namespace symplant::test {
namespace {

using tables::kSecond;

HandUnit instant_unit() { return {2, {0, 1}, {{1, 0, 0, 0, kSecond}, {0, 1, 1, 0, kSecond}}}; }

struct Seen {
  tables::Time time;
  std::vector<std::uint32_t> units;
  std::vector<engine::WordChange> operations;
  std::vector<engine::WordChange> events;
};

class Log final : public engine::Observer {
 public:
  void instant(const engine::Instant& instant) noexcept override {
    seen.push_back({instant.time,
                    {instant.units.begin(), instant.units.end()},
                    {instant.operations.begin(), instant.operations.end()},
                    {instant.events.begin(), instant.events.end()}});
  }
  std::vector<Seen> seen;
};

TEST_CASE("A written value belongs to the instant of the call, together with what is due then") {
  HandPlant plant({instant_unit()});
  Log log;
  plant.to(0);
  plant.set(0, 1, true);
  plant.to(0);
  plant.set(0, 1, false);
  plant.set(0, 0, true);
  plant.to(kSecond, &log);  // arrives in 1 and leaves at once
  REQUIRE(log.seen.size() == 1);
  CHECK(plant.unit(0).target == 0);
  CHECK(plant.unit(0).moving);
  // Event 1 turned on and off within the instant: no net change.
  CHECK(log.seen[0].events.empty());
  CHECK(log.seen[0].units == std::vector<std::uint32_t>{0});
}

TEST_CASE("What is due before the call runs on the old operations") {
  HandPlant plant({instant_unit(), instant_unit()});
  Log log;
  plant.to(0);
  plant.set(0, 1, true);
  plant.to(0);
  plant.set(0, 0, true);
  plant.set(1, 1, true);
  plant.to(2 * kSecond, &log);
  REQUIRE(log.seen.size() == 2);
  CHECK(log.seen[0].time == kSecond);
  CHECK(log.seen[0].operations.empty());
  CHECK(log.seen[1].time == 2 * kSecond);
  CHECK(log.seen[1].operations.size() == 2);
}

TEST_CASE("The same time runs another instant only if a value was written") {
  HandPlant plant({instant_unit()});
  Log log;
  plant.to(0);
  plant.to(5, &log);
  plant.to(5, &log);
  CHECK(log.seen.empty());
  plant.set(0, 1, true);
  plant.to(5, &log);
  CHECK(log.seen.size() == 1);
  CHECK(plant.unit(0).moving);
}

TEST_CASE("A time in the past is taken as now") {
  HandPlant plant({instant_unit()});
  plant.to(5);
  plant.set(0, 1, true);
  plant.to(3);
  CHECK(plant.plant->now() == 5);
  CHECK(plant.unit(0).moving);
}

TEST_CASE("An operation that ends with its old value is no change") {
  HandPlant plant({instant_unit()});
  Log log;
  plant.to(0);
  plant.set(0, 1, true);
  plant.set(0, 1, false);
  plant.to(1, &log);
  CHECK(log.seen.empty());
}

TEST_CASE("The first instant reports the events that are on") {
  HandPlant plant({instant_unit()});
  Log log;
  plant.to(0, &log);
  REQUIRE(log.seen.size() == 1);
  REQUIRE(log.seen[0].events.size() == 1);
  CHECK(log.seen[0].events[0].bits == 1);
}

TEST_CASE("The first instant runs at 0 even if the first call is for later") {
  HandUnit spring{2, {1}, {{0, 1, 0, 0, kSecond}}, tables::Actuation::spring, 0, 1, kSecond};
  HandPlant plant({spring});
  Log log;
  plant.to(3 * kSecond, &log);
  REQUIRE(log.seen.size() == 2);
  CHECK(log.seen[0].time == 0);
  CHECK(log.seen[1].time == kSecond);
}

TEST_CASE("A link receives each changed event word once") {
  HandPlant plant({instant_unit(), instant_unit()});
  plant.to(0);
  plant.plant->forget_changed_events();
  plant.set(1, 1, true);
  plant.to(1);
  plant.to(1 + kSecond);
  const auto changed = plant.plant->changed_events();
  REQUIRE(changed.size() == 1);
  CHECK(changed[0] == 1);
  plant.plant->forget_changed_events();
  CHECK(plant.plant->changed_events().empty());
}

TEST_CASE("next_due returns the earliest time of an automatic change") {
  HandPlant plant({instant_unit(), instant_unit()});
  CHECK(plant.plant->next_due() == 0);
  plant.to(0);
  CHECK(plant.plant->next_due() == tables::kNever);
  plant.set(0, 1, true);
  plant.to(10);
  plant.set(1, 1, true);
  plant.to(20);
  CHECK(plant.plant->next_due() == 10 + kSecond);
  plant.to(10 + kSecond);
  CHECK(plant.plant->next_due() == 20 + kSecond);
}

}  // namespace
}  // namespace symplant::test
