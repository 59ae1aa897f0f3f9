// SP401 operation-without-event: no event reports a state that the PLC commands.
#include <fmt/format.h>

#include <algorithm>

#include "check/rules.hpp"
#include "check/spelling/device_classes.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kOperationWithoutEventPage =
    R"(A device has an operation for a task and events for other tasks, but no event for this one: `O_P2` without `I_P2`. Devices
of one type (`CLAMP1`, `CLAMP2`) make one finding; its related rows are the other symbols.

The rule does not apply to devices without any event (lamps, plain motors), nor to operations that have no feedback by nature:
ACK, BUZZER, BYPASS, HORN, LAMP, LED, MUTE, RESET and RST, with or without a number.

**What the model loses.** The device goes to that state and no input reports it. A program that waits for the event waits
forever. Most often the event is missing in the list, or its task has another spelling.

**How to fix it.** Add the event, or spell both tasks alike. In plant.json, `outputs` can switch another event on in that state.
)";

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

}  // namespace

const Rule kOperationWithoutEvent{{"SP401", "operation-without-event", diag::Severity::warning,
                                   "no event reports a state that the PLC commands", kOperationWithoutEventPage},
                                  check_operation_without_event};

}  // namespace symplant::check
