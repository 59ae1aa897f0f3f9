// Rules: operations without events, and events without operations.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "check/rules.hpp"
#include "check/spelling/device_classes.hpp"
#include "check/spelling/odd_devices.hpp"
#include "model/part_words.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

/// Whether the state switches an event on that is not its own.
bool reports_by_outputs(const model::Unit& unit, std::uint32_t state) {
  if (unit.outputs.empty()) return false;
  const auto& enter = unit.outputs[state].enter;
  return std::any_of(enter.begin(), enter.end(), [](const auto& output) { return output.second; });
}

/// Under a custom naming rule a task that no device of the type reports is one without feedback: the score counts it.
bool is_never_reported(const Subject& subject, const model::Unit& unit, const std::string& task) {
  if (subject.plant.pairing == nullptr) return false;
  const auto device = static_cast<std::uint32_t>(&unit - subject.plant.units.data());
  return subject.classes.find(subject.classes.class_of(device), tables::Direction::event, task) == model::kNone;
}

void check_operation_without_event(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (unit.events.empty() || is_one_word_twice(subject, unit) || unit.has_behaviour() || unit.is_archetype())
      continue;  // the user's code reports, or the roles say what is reported
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      const model::State& state = unit.states[s];
      if (state.operation == model::kNone || state.event != model::kNone || needs_no_feedback(state.name)) continue;
      if (reports_by_outputs(unit, s) || (s != unit.initial && !unit.reaches(s))) continue;
      if (subject.overruled.has(unit, state, name::Direction::event)) continue;  // SP305 or SP407
      if (is_never_reported(subject, unit, state.name)) continue;
      const model::Symbol& symbol = operation_of(plant, unit, state.operation);
      diag::Diagnostic& finding =
          diagnostics.add(rule.info,
                          about(symbol)
                              .following(device(unit.path))
                              .following(missing(plant, unit.path, tables::Direction::event, state.name)),
                          fmt::format("`{}` commands `{}` of `{}`, but no event reports that state: add an event with "
                                      "task `{}`",
                                      symbol.name(), state.name, unit.path, state.name),
                          location_of(plant, symbol));
      finding.subjects.shape = type_shape(unit);
    }
  }
}

void check_event_without_operation(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      const model::State& state = unit.states[s];
      if (unled(subject, unit, s) != Unled::no_operation) continue;
      const model::Symbol& symbol = event_of(plant, unit, state.event);
      diag::Diagnostic& finding = diagnostics.add(
          rule.info,
          about(symbol)
              .following(device(unit.path))
              .following(missing(plant, unit.path, tables::Direction::operation, state.name)),
          fmt::format("`{}` reports `{}` of `{}`, but no operation leads there: add an operation with task `{}`, or "
                      "number the tasks if the device enters it automatically{}",
                      symbol.name(), state.name, unit.path, state.name,
                      unit.described == nullptr ? "" : ", or describe a transition"),
          location_of(plant, symbol));
      finding.subjects.shape = type_shape(unit);
    }
  }
}

void check_unit_without_events(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (!unit.events.empty()) continue;
    diagnostics.add(rule.info, about_sides(plant, unit, about(unit)),
                    fmt::format("`{}` has operations and no event: no input of the PLC reports its state", unit.path),
                    location_of(plant, first_symbol_of(plant, unit)));
  }
}

/// Whether an event follows another one on its address that something drives.
bool follows_a_driven_one(const model::PlantModel& plant, std::uint32_t event) {
  const std::uint32_t leader = plant.symbols[event].leader;
  if (leader == model::kNone) return false;
  if (plant.symbols[leader].driven_without_unit()) return true;
  if (plant.symbols[leader].unit == model::kNone) return false;
  return plant.units[plant.symbols[leader].unit].moves();
}

/// The events of a unit without operations that nothing switches.
std::vector<std::uint32_t> left_alone(const model::PlantModel& plant, const model::Unit& unit) {
  std::vector<std::uint32_t> left;
  for (std::uint32_t location = 0; location < unit.events.size(); ++location) {
    if (unit.moves_event(location) || follows_a_driven_one(plant, unit.events[location])) continue;
    const bool sensor = !plant.material.empty() && model::looks_like_part_sensor(event_of(plant, unit, location));
    if (!sensor) left.push_back(unit.events[location]);  // SP630 reports those
  }
  return left;
}

/// Whether an event without a driver is on: that of the initial state, or no state's at all and Initial TRUE.
bool is_on(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t symbol) {
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    const std::uint32_t event = unit.states[s].event;
    if (event != model::kNone && unit.events[event] == symbol) {
      return (s == unit.initial) != plant.symbols[symbol].inverted;
    }
  }
  return plant.symbols[symbol].initial != 0;
}

void check_event_not_driven(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (!unit.operations.empty()) continue;
    const std::vector<std::uint32_t> left = left_alone(plant, unit);
    if (left.empty()) continue;
    const model::Symbol& symbol = plant.symbols[left.front()];
    const std::string_view why =
        unit.moves() ? "since no state that the device reaches switches it" : "since the device has no operation";
    std::string message;
    if (left.size() > 1) {
      message = fmt::format("`{}` and {} more of `{}`: no device drives them, {}; they keep their initial values",
                            symbol.name(), left.size() - 1, unit.path, why);
    } else if (is_on(plant, unit, left.front())) {
      message = fmt::format("`{}`: no device drives it, {}; it stays on, as {} says", symbol.name(), why,
                            symbol.initial != 0 ? "Initial"
                            : symbol.inverted   ? "`inverted`"
                                                : "the description");
    } else {
      message = fmt::format(
          "`{}`: no device drives it, {}; it stays off; if it is a contact that is on in a healthy plant, "
          "write Initial TRUE",
          symbol.name(), why);
    }
    diagnostics.add(rule.info, about_sides(plant, unit, about(symbol).following(symbol_named(symbol.name()))),
                    std::move(message), location_of(plant, symbol));
  }
}

/// A task without the number of its sensor: `RET` of `RET2`.
std::string_view end_of(std::string_view task) {
  while (!task.empty() && (text::is_digit(task.back()) || task.back() == '_')) task.remove_suffix(1);
  return task;
}

bool has_event_of(const model::PlantModel& plant, const model::Unit& unit, std::string_view end) {
  return std::any_of(unit.events.begin(), unit.events.end(), [&](std::uint32_t event) {
    return text::equal_ignoring_case(end_of(plant.symbols[event].reading.task()), end);
  });
}

void check_end_without_sensor(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.pairing == nullptr) return;
  for (const OddDevice& odd : odd_devices(subject)) {
    if (odd.device >= plant.units.size()) continue;
    const model::Unit& unit = plant.units[odd.device];
    if (unit.events.empty()) continue;
    for (const Lacking& lacking : odd.lacks) {
      const std::string_view end = end_of(lacking.others->reading.task());
      if (lacking.others->direction != tables::Direction::event || has_event_of(plant, unit, end)) continue;
      const diag::Subject sensor = missing(plant, unit.path, tables::Direction::event, end);
      diagnostics.add(
          rule.info, about(unit).explaining(sensor),
          fmt::format("`{}` has no sensor of `{}`: {} of {} devices named like it have one; add the row, or "
                      "spell it as they do",
                      unit.path, end, lacking.having, odd.of),
          location_of(plant, plant.symbols[unit.events.front()]),
          {{location_of(plant, *lacking.others), "one that has it"}});
      break;
    }
  }
}

}  // namespace

const Rule kOperationWithoutEvent{
    {"SP401", "operation-without-event", diag::Severity::warning, "no event reports a state that the PLC commands",
     R"(A device has an operation for a task and events for other tasks, but no event for this one: `O_P2` without `I_P2`. Devices
of one type (`CLAMP1`, `CLAMP2`) make one finding; its related rows are the other symbols.

The rule does not apply to devices without any event (lamps, plain motors), nor to operations that have no feedback by nature:
ACK, BUZZER, BYPASS, HORN, LAMP, LED, MUTE, RESET and RST, with or without a number.

**What the model loses.** The device goes to that state and no input reports it. A program that waits for the event waits
forever. Most often the event is missing in the list, or its task has another spelling.

**How to fix it.** Add the event, or spell both tasks alike. In plant.json, `outputs` can switch another event on in that state.
)"},
    check_operation_without_event};

const Rule kEventWithoutOperation{
    {"SP402", "event-without-operation", diag::Severity::warning, "no operation leads to the state of an event",
     R"(A device has an event for a task, but no operation for it, and nothing else that was inferred leads there: it is neither
the rest state of a spring nor the next one of a numbered sequence. Devices of one type (`CLAMP1`, `CLAMP2`) make one finding;
its related rows are the other symbols.

**What the model loses.** The event never comes on by itself. A program that waits for it waits forever.

**How to fix it.** Add the operation, spell both tasks alike, or number the tasks in their order (`IDLE1`, `RUN2`) if the
device goes on to this one by itself. Or describe a transition to the state in plant.json. For a further
sensor of a position that has one (`ADV1`, `ADV2`), switch its event on with `outputs`.
)"},
    check_event_without_operation};

const Rule kUnitWithoutEvents{{"SP403", "unit-without-events", diag::Severity::note, "a device gives no feedback",
                               R"(A device has operations and no event: a lamp, a horn, a motor without contacts.

**What the model loses.** Nothing, if the device is like that. It moves, and no input of the PLC reports it.

**How to fix it.** Nothing to do, unless its events have the name of another device.
)",
                               diag::Rank::sides},
                              check_unit_without_events};

const Rule kEventNotDriven{
    {"SP404", "event-not-driven", diag::Severity::note, "inputs of the PLC that no device drives",
     R"(A device has events and no operation: a push button, a light barrier, a healthy contact (emergency stop, air, doors).

**What the model loses.** No device drives these inputs: they keep their initial value until a scenario, a link or a person sets
them. A program that waits for healthy contacts never starts.

**How to fix it.** If such a contact is on in a healthy plant, give it the initial value TRUE in the list. If something in the
plant drives it, describe that in plant.json: automatic transitions with a `when`, or a behavior.
)",
     diag::Rank::sides},
    check_event_not_driven};

const Rule kEndWithoutSensor{
    {"SP417", "end-without-sensor", diag::Severity::warning,
     "one end position lacks its sensor where sibling devices have two",
     R"(Under a naming rule of your own, a device has sensors of one end of its motion only, and nearly all devices whose names differ only in
digits have sensors of both ends. Under the built-in rule SP414 reports this.

**What the model loses.** The PLC waits for the missing sensor in vain: nothing in the plant sets it.

**How to fix it.** Add the row, or spell the end as the other devices do. If the device has no such sensor, ignore the finding.
)",
     diag::Rank::siblings},
    check_end_without_sensor};

}  // namespace symplant::check
