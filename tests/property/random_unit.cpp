// Random units: of every kind that names can determine, and of no kind.
#include "property/random_unit.hpp"

#include <algorithm>

namespace symplant::property {
namespace {

const std::vector<std::string> kWords = {"ADV",  "RET",  "OPEN", "CLOSE", "UP", "DOWN", "HOME", "RUN",
                                         "IDLE", "WORK", "DONE", "CLAMP", "P",  "Q",    "LOAD", "MOVING"};
const std::vector<std::string> kTypes = {"INT",   "WORD", "REAL", "LREAL", "DINT",  "LINT",  "ULINT",
                                         "USINT", "SINT", "BYTE", "UINT",  "DWORD", "UDINT", "LWORD"};

bool holds(const PlannedUnit& unit, const std::string& task) {
  const auto named = [&](const PlannedTask& planned) { return planned.name == task; };
  return std::any_of(unit.tasks.begin(), unit.tasks.end(), named) ||
         std::find(unit.added.begin(), unit.added.end(), task) != unit.added.end();
}

std::string new_task(Dice& dice, const PlannedUnit& unit, unsigned numbered) {
  for (;;) {
    std::string task = dice.pick(kWords);
    if (dice.percent(numbered)) task += std::to_string(1 + dice.below(4));
    if (!holds(unit, task)) return task;
  }
}

void add_task(Dice& dice, PlannedUnit& unit, unsigned numbered, unsigned operation, unsigned event) {
  PlannedTask task{new_task(dice, unit, numbered), dice.percent(operation), dice.percent(event)};
  if (!task.operation && !task.event) (dice.percent(50) ? task.operation : task.event) = true;
  unit.tasks.push_back(std::move(task));
}

/// IDLE1, RUN2 ...: some without an operation, so that automatic transitions lead to them.
void plan_sequence(Dice& dice, PlannedUnit& unit) {
  const std::size_t count = 2 + dice.below(dice.percent(20) ? 6 : 3);
  for (std::size_t i = 0; i < count; ++i) {
    PlannedTask task{dice.pick(kWords) + std::to_string(i + 1), dice.percent(60), dice.percent(85)};
    if (!task.operation) task.event = true;
    unit.tasks.push_back(std::move(task));
  }
  if (dice.percent(30)) dice.shuffle(unit.tasks);
}

void plan_tasks(Dice& dice, PlannedUnit& unit) {
  const std::size_t kind = dice.below(100);
  if (kind < 24) {
    plan_sequence(dice, unit);
  } else if (kind < 44) {
    for (int i = 0; i < 2; ++i) add_task(dice, unit, 30, 100, 85);
  } else if (kind < 55) {
    add_task(dice, unit, 20, 75, 75);
  } else if (kind < 68) {
    add_task(dice, unit, 20, 100, 100);
    add_task(dice, unit, 0, 0, 100);
  } else {
    const std::size_t count = 1 + dice.below(dice.percent(15) ? 8 : 3);
    for (std::size_t i = 0; i < count; ++i) add_task(dice, unit, 30, 65, 75);
  }
}

/// Up to the highest number of operations and events of a unit.
void plan_large(Dice& dice, PlannedUnit& unit) {
  const std::size_t count = 50 + dice.below(15);
  for (std::size_t i = 0; i < count; ++i) {
    unit.tasks.push_back({"S" + std::to_string(i + 1), dice.percent(95), true});
  }
}

/// What a behavior needs.
void plan_behaviour(Dice& dice, PlannedUnit& unit) {
  unit.behaves = true;
  if (unit.operations().empty()) unit.tasks.front().operation = true;
  if (unit.events().empty()) unit.tasks.front().event = true;
  if (unit.states().size() < 2) add_task(dice, unit, 30, 65, 75);
  while (unit.values.size() < 2) {
    unit.values.push_back(random_value(dice, "V" + std::to_string(unit.values.size()), dice.percent(30)));
  }
}

}  // namespace

std::vector<std::string> PlannedUnit::states() const {
  std::vector<std::string> all;
  for (const PlannedTask& task : tasks) all.push_back(task.name);
  all.insert(all.end(), added.begin(), added.end());
  return all;
}

std::vector<std::string> PlannedUnit::operations() const {
  std::vector<std::string> all = commands;
  for (const PlannedTask& task : tasks) {
    if (task.operation) all.push_back(task.name);
  }
  return all;
}

std::vector<std::string> PlannedUnit::events() const {
  std::vector<std::string> all = signals;
  for (const PlannedTask& task : tasks) {
    if (task.event) all.push_back(task.name);
  }
  return all;
}

PlannedValue random_value(Dice& dice, std::string name, bool operation) {
  return {std::move(name), dice.pick(kTypes), operation};
}

PlannedUnit random_unit(Dice& dice, std::size_t number) {
  PlannedUnit unit;
  unit.path = "L" + std::to_string(dice.below(2));
  unit.path += (dice.percent(10) ? "_P_d" : "_P_D") + std::to_string(number);
  if (dice.one_in(600)) {
    plan_large(dice, unit);
  } else {
    plan_tasks(dice, unit);
  }
  if (dice.percent(15)) unit.added.push_back(new_task(dice, unit, 30));
  if (dice.percent(18)) unit.commands.push_back("PUSH");
  if (dice.percent(4)) unit.commands.push_back("KICK");
  if (dice.percent(15)) unit.signals.push_back("BUSY");
  if (dice.percent(5)) unit.signals.push_back("FAULT");
  if (dice.percent(20)) unit.values.push_back(random_value(dice, "SPEED", dice.percent(50)));
  if (dice.percent(8)) plan_behaviour(dice, unit);
  return unit;
}

description::Sequence random_sequence(Dice& dice) { return static_cast<description::Sequence>(dice.below(3)); }

tables::Time random_overrun(Dice& dice) {
  if (dice.percent(10)) return tables::kNever;
  return dice.percent(15) ? 2 * tables::kSecond : random_time(dice);
}

tables::Time random_time(Dice& dice) {
  using tables::kMillisecond;
  static const std::vector<tables::Time> kGrid = {10 * kMillisecond, 10 * kMillisecond, 20 * kMillisecond,
                                                  20 * kMillisecond, 50 * kMillisecond, tables::kSecond};
  static const std::vector<tables::Time> kOdd = {1,          7,        10 * kMillisecond + 1, 20 * kMillisecond - 1,
                                                 33'333'333, 5'000'003};
  if (dice.one_in(400)) return tables::kNever - static_cast<tables::Time>(dice.below(3));
  if (dice.percent(18)) return 0;
  return dice.percent(12) ? dice.pick(kOdd) : dice.pick(kGrid);
}

description::Duration random_duration(Dice& dice) {
  description::Duration duration = description::Duration::fixed(random_time(dice));
  if (!dice.percent(15)) return duration;
  duration.b = random_time(dice);
  duration.kind = dice.percent(50) ? description::Duration::Kind::uniform : description::Duration::Kind::normal;
  constexpr tables::Time kMost = 100 * tables::kSecond;
  if (duration.kind == description::Duration::Kind::normal) {
    duration.a = std::min(duration.a, kMost);
    duration.b = std::min(duration.b, kMost);
  } else if (duration.a > duration.b) {
    std::swap(duration.a, duration.b);
  }
  return duration;
}

}  // namespace symplant::property
