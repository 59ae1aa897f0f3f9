// The engine on latched units: commands, automatic transitions, arming, rounds.
#include "support/catch.hpp"
#include "support/hand_plant.hpp"

namespace symplant::test {
namespace {

using tables::kMillisecond;
using tables::kNoOperation;
using tables::kSecond;

/// Two states, an operation each, a second's travel.
HandUnit double_solenoid() { return {2, {0, 1}, {{1, 0, 0, 0, kSecond}, {0, 1, 1, 0, kSecond}}}; }

/// IDLE, RUN with an operation, and back by itself after a second.
HandUnit machine() { return {2, {1}, {{0, 1, 0, 0, kSecond}, {1, 0, kNoOperation, kSecond, 0}}}; }

TEST_CASE("at the start a unit is settled in its initial state and its event is on") {
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

TEST_CASE("a commanded move leaves at once, travels its time and arrives") {
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

TEST_CASE("a latched move goes on when its command goes off, and whatever else is commanded") {
  HandPlant plant({double_solenoid()});
  plant.to(0);
  plant.set(0, 1, true);
  plant.to(1);
  plant.set(0, 1, false);
  plant.set(0, 0, true);
  plant.to(2);
  CHECK(plant.unit(0).target == 1);
  plant.to(1 + kSecond);
  // Levels count: the command that is on when it arrives is obeyed then, in the same instant.
  CHECK(plant.unit(0).moving);
  CHECK(plant.unit(0).target == 0);
  CHECK_FALSE(plant.event(0, 1));
}

TEST_CASE("two commands for different states leave a unit where it is") {
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

TEST_CASE("a command for the state a unit is in holds it there against another") {
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

TEST_CASE("one operation may toggle a unit: it is no wish to stay where it is the way out") {
  const HandUnit toggle{2, {tables::kNoState}, {{0, 1, 0, 0, kSecond}, {1, 0, 0, 0, kSecond}}};
  HandPlant plant({toggle});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(1);
  CHECK(plant.unit(0).target == 1);
  plant.to(1 + kSecond);
  CHECK(plant.unit(0).target == 0);  // still on: back again
}

TEST_CASE("an automatic transition leaves when its state has lasted, and the old command does not start it again") {
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
  CHECK(plant.unit(0).state == 0);  // the command is on still, but disarmed

  plant.set(0, 0, false);
  plant.to(11 * kSecond);
  plant.set(0, 0, true);
  plant.to(12 * kSecond);
  CHECK(plant.unit(0).moving);  // off and on: armed again
}

TEST_CASE("a command that was off when the machine was done stays armed") {
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

TEST_CASE("a command that goes off and on between two instants is not armed by it") {
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

TEST_CASE("of several automatic transitions that are ready at once the first of the table fires") {
  const HandUnit unit{3, {}, {{0, 2, kNoOperation, kSecond, 0}, {0, 1, kNoOperation, kSecond, 0}}};
  HandPlant plant({unit});
  plant.to(kSecond);
  CHECK(plant.unit(0).state == 2);
}

TEST_CASE("the earliest of several automatic transitions fires") {
  const HandUnit unit{3, {}, {{0, 2, kNoOperation, 2 * kSecond, 0}, {0, 1, kNoOperation, kSecond, 0}}};
  HandPlant plant({unit});
  plant.to(5 * kSecond);
  CHECK(plant.unit(0).state == 1);
}

TEST_CASE("a command interrupts the waiting for an automatic transition") {
  const HandUnit unit{3, {2}, {{0, 2, 0, 0, kSecond}, {0, 1, kNoOperation, kSecond, 0}}};
  HandPlant plant({unit});
  plant.to(0);
  plant.set(0, 0, true);
  plant.to(kSecond / 2);
  plant.to(5 * kSecond);
  CHECK(plant.unit(0).state == 2);
}

TEST_CASE("ways that take no time are gone in one instant, round by round") {
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

TEST_CASE("a time beyond all time is never due") {
  HandUnit unit = double_solenoid();
  unit.routes[1].takes = tables::kNever;
  HandPlant plant({unit});
  plant.to(0);
  plant.set(0, 1, true);
  plant.to(1);
  CHECK(plant.unit(0).moving);
  CHECK(plant.plant->next_due() == tables::kNever);
}

TEST_CASE("advancing to the end of all time ends") {
  HandPlant plant({double_solenoid(), machine()});
  plant.to(0);
  plant.set(1, 0, true);
  plant.to(1);
  plant.to(tables::kNever);
  CHECK(plant.unit(1).state == 0);
  CHECK(plant.plant->now() == tables::kNever);
}

TEST_CASE("a thousand plants in one process do not know of each other") {
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

TEST_CASE("reset puts everything back to the start") {
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
