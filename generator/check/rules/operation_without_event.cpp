// SP401 operation-without-event: the PLC commands a state and is never told that it is reached.
#include <fmt/format.h>

#include <algorithm>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kOperationWithoutEventPage =
    R"(A device has an operation for a task and reports on other tasks, but has no event for this one: `O_P2` without `I_P2`.

**What the model loses.** The device moves to that state and nothing tells the PLC. A program that waits for the report
waits for ever. Most often the event is missing in the list, or its task is spelled in another way.

**How to fix it.** Add the event, or spell both tasks alike; or let `outputs` in plant.json switch an event in that state. Devices without any event (lamps, plain motors) are not
meant by this rule.
)";

/// Whether the state switches an event on that is not its own.
bool reports_by_outputs(const model::Unit& unit, std::uint32_t state) {
  if (unit.outputs.empty()) return false;
  const auto& enter = unit.outputs[state].enter;
  return std::any_of(enter.begin(), enter.end(), [](const auto& output) { return output.second; });
}

void check_operation_without_event(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (unit.events.empty() || evidence_of(subject, unit).two_words || unit.has_behaviour()) continue;  // the user's code reports
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      const model::State& state = unit.states[s];
      if (state.operation == model::kNone || state.event != model::kNone) continue;
      if (reports_by_outputs(unit, s) || (s != unit.initial && !unit.reaches(s))) continue;
      if (subject.overruled.has(unit, state, name::Direction::event)) continue;  // SP305 or SP407 tells
      const model::Symbol& symbol = operation_of(plant, unit, state.operation);
      diagnostics.add(
          rule.info, about(symbol),
          fmt::format("`{}` commands `{}` of `{}`, but no event tells the PLC that it is reached: add an event with "
                      "task `{}`",
                      symbol.name(), state.name, unit.path, state.name),
          location_of(plant, symbol));
    }
  }
}

}  // namespace

const Rule kOperationWithoutEvent{
    {"SP401", "operation-without-event", diag::Severity::warning,
     "the PLC commands a state and is never told that it is reached", kOperationWithoutEventPage},
    check_operation_without_event};

}  // namespace symplant::check
