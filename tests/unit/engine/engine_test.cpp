// The engine on latched units: commands, automatic transitions, arming, rounds.
#include "support/catch.hpp"
#include "support/hand_plant.hpp"

namespace symplant::test {
namespace {

using tables::kMillisecond;
using tables::kNoOperation;
using tables::kSecond;

/// Two states with an operation each, 1 s of travel.
HandUnit double_solenoid() { return {2, {0, 1}, {{1, 0, 0, 0, kSecond}, {0, 1, 1, 0, kSecond}}}; }

/// IDLE, RUN with an operation, and automatically back after 1 s.
HandUnit machine() { return {2, {1}, {{0, 1, 0, 0, kSecond}, {1, 0, kNoOperation, kSecond, 0}}}; }

TEST_CASE("A unit starts settled in its initial state with its event on") {
  HandUnit second = double_solenoid();
  second.initial = 1;
  HandPlant plant({double_solenoid(), second});
  plant.to(0);
  CHECK(plant.event(0, 0));
  CHECK_FALSE(plant.event(0, 1));
  CHECK_FALSE(plant.event(1, 0));
  CHECK(plant.event(1, 1));
  CHECK_FALSE(plant.unit(1).moving);
  CHECK(plant.unit(1).state == 1);
}

TEST_CASE("A commanded move leaves at once, travels its time and arrives") {
  HandPlant plant({double_solenoid()});
  plant.to(0);
  plant.set(0, 1, true);
  plant.to(500 * kMillisecond);
  CHECK_FALSE(plant.event(0, 0));
  CHECK(plant.unit(0).moving);
  CHECK(plant.unit(0).target == 1);
  CHECK(plant.unit(0).remaining == kSecond);
  plant.to(kSecond);
  CHECK(plant.unit(0).remaining == 500 * kMillisecond);
  CHECK(plant.unit(0).progress == 0.5);
  plant.to(1500 * kMillisecond - 1);
  CHECK_FALSE(plant.event(0, 1));
  plant.to(1500 * kMillisecond);
  CHECK(plant.event(0, 1));
  CHECK_FALSE(plant.unit(0).moving);
}

TEST_CASE("A latched move continues when its command goes off, and with any other command") {
  HandPlant plant({double_solenoid()});
  plant.to(0);
  plant.set(0, 1, true);
  plant.to(1);
  plant.set(0, 1, false);
  plant.set(0, 0, true);
  plant.to(2);
  CHECK(plant.unit(0).target == 1);
  plant.to(1 + kSecond);
  // Levels count: the command that is on at arrival takes effect in the same instant.
  CHECK(plant.unit(0).moving);
  CHECK(plant.unit(0).target == 0);
  CHECK_FALSE(plant.event(0, 1));
}

TEST_CASE("Two commands for different states leave a unit in its state") {
  const HandUnit three{3,
                       {0, 1, 2},
                       {{1, 0, 0, 0, kSecond},
                        {2, 0, 0, 0, kSecond},
                        {0, 1, 1, 0, kSecond},
                        {2, 1, 1, 0, kSecond},
                        {0, 2, 2, 0, kSecond},
                        {1, 2, 2, 0, kSecond}}};
  HandPlant plant({three});
  plant.to(0);
  plant.set(0, 1, true);
  plant.set(0, 2, true);
  plant.to(1);
  CHECK_FALSE(plant.unit(0).moving);
  plant.set(0, 1, false);
  plant.to(2);
  CHECK(plant.unit(0).target == 2);
}

TEST_CASE("A command for the current state holds the unit against another command") {
  HandPlant plant({double_solenoid()});
  plant.to(0);
  plant.set(0, 0, true);
  plant.set(0, 1, true);
  plant.to(1);
  CHECK_FALSE(plant.unit(0).moving);
  plant.set(0, 0, false);
  plant.to(2);
  CHECK(plant.unit(0).moving);
}

TEST_CASE("One operation can toggle a unit: it does not hold the unit in the state that it leaves") {
  const HandUnit toggle{2, {tables::kNoState}, {{0, 1, 0, 0, kSecond}, {1, 0, 0, 0, kSecond}}};
  HandPlant plant({toggle});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(1);
  CHECK(plant.unit(0).target == 1);
  plant.to(1 + kSecond);
  CHECK(plant.unit(0).target == 0);  // still on: moves back
}

TEST_CASE("An automatic transition leaves when its state has lasted, and the old command does not restart it") {
  HandPlant plant({machine()});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(1);
  plant.to(1 + kSecond);
  CHECK(plant.event(0, 1));
  plant.to(1 + 2 * kSecond - 1);
  CHECK(plant.event(0, 1));
  plant.to(1 + 2 * kSecond);
  CHECK(plant.event(0, 0));
  CHECK(plant.plant->next_due() == tables::kNever);
  plant.to(10 * kSecond);
  CHECK(plant.unit(0).state == 0);  // the command is still on, but disarmed

  plant.set(0, 0, false);
  plant.to(11 * kSecond);
  plant.set(0, 0, true);
  plant.to(12 * kSecond);
  CHECK(plant.unit(0).moving);  // off and on: armed again
}

TEST_CASE("A command that was off when the machine finished stays armed") {
  HandPlant plant({machine()});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(1);
  plant.set(0, 0, false);
  plant.to(2);
  plant.to(3 * kSecond);
  CHECK(plant.unit(0).state == 0);
  plant.set(0, 0, true);
  plant.to(4 * kSecond);
  CHECK(plant.unit(0).moving);
}

TEST_CASE("A command that goes off and on between two instants is not armed by it") {
  HandPlant plant({machine()});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(1);
  plant.to(3 * kSecond);
  plant.set(0, 0, false);
  plant.set(0, 0, true);
  plant.to(4 * kSecond);
  CHECK_FALSE(plant.unit(0).moving);
}

TEST_CASE("The first in the table fires if several automatic transitions are ready") {
  const HandUnit unit{3, {}, {{0, 2, kNoOperation, kSecond, 0}, {0, 1, kNoOperation, kSecond, 0}}};
  HandPlant plant({unit});
  plant.to(kSecond);
  CHECK(plant.unit(0).state == 2);
}

TEST_CASE("The earliest of several automatic transitions fires") {
  const HandUnit unit{3, {}, {{0, 2, kNoOperation, 2 * kSecond, 0}, {0, 1, kNoOperation, kSecond, 0}}};
  HandPlant plant({unit});
  plant.to(5 * kSecond);
  CHECK(plant.unit(0).state == 1);
}

TEST_CASE("A command interrupts the waiting for an automatic transition") {
  const HandUnit unit{3, {2}, {{0, 2, 0, 0, kSecond}, {0, 1, kNoOperation, kSecond, 0}}};
  HandPlant plant({unit});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(kSecond / 2);
  plant.to(5 * kSecond);
  CHECK(plant.unit(0).state == 2);
}

TEST_CASE("Transitions without travel time complete in one instant, round by round") {
  const HandUnit chain{
      4, {tables::kNoState}, {{0, 1, 0, 0, 0}, {1, 2, kNoOperation, 0, 0}, {2, 3, kNoOperation, 0, 0}}};
  HandPlant plant({chain});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(1);
  CHECK(plant.unit(0).state == 3);
  CHECK_FALSE(plant.event(0, 0));
  CHECK(plant.event(0, 3));
  CHECK(plant.plant->now() == 1);
}

TEST_CASE("A time out of range is never due") {
  HandUnit unit = double_solenoid();
  unit.routes[1].takes = tables::kNever;
  HandPlant plant({unit});
  plant.to(0);
  plant.set(0, 1, true);
  plant.to(1);
  CHECK(plant.unit(0).moving);
  CHECK(plant.plant->next_due() == tables::kNever);
}

TEST_CASE("Advancing to the end of time ends") {
  HandPlant plant({double_solenoid(), machine()});
  plant.to(0);
  plant.set(1, 0, true);
  plant.to(1);
  plant.to(tables::kNever);
  CHECK(plant.unit(1).state == 0);
  CHECK(plant.plant->now() == tables::kNever);
}

TEST_CASE("A thousand plants in one process are independent") {
  std::vector<std::unique_ptr<HandPlant>> plants;
  for (int i = 0; i < 1000; ++i) plants.push_back(std::make_unique<HandPlant>(std::vector{double_solenoid()}));
  for (auto& plant : plants) plant->to(0);
  plants[500]->set(0, 1, true);
  for (auto& plant : plants) plant->to(kSecond);
  for (auto& plant : plants) plant->to(2 * kSecond);
  for (int i = 0; i < 1000; ++i) {
    INFO(i);
    CHECK(plants[static_cast<std::size_t>(i)]->unit(0).state == (i == 500 ? 1 : 0));
  }
}

TEST_CASE("A reset restores the start") {
  HandPlant plant({double_solenoid(), machine()});
  plant.to(0);
  plant.set(0, 1, true);
  plant.set(1, 0, true);
  plant.to(1500 * kMillisecond);
  plant.plant->reset();
  CHECK(plant.plant->now() == 0);
  CHECK(plant.plant->next_due() == 0);
  plant.to(10 * kSecond);
  CHECK(plant.event(0, 0));
  CHECK(plant.event(1, 0));
  CHECK_FALSE(plant.plant->operation(1));
}

}  // namespace
}  // namespace symplant::test
