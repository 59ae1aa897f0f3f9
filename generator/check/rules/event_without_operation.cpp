// SP402 event-without-operation: a device reports a state that it can never reach.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kEventWithoutOperationPage =
    R"(A device has an event for a task, but no operation for it, and nothing else that was inferred leads there: it is neither
the rest state of a spring nor the next one of a numbered sequence.

**What the model loses.** The event never comes on by itself. A program that waits for it waits for ever.

**How to fix it.** Add the operation, spell both tasks alike, or number the tasks in their order (`IDLE1`, `RUN2`) if the
device goes on to this one by itself. In plant.json a transition to the state says what else leads there.
)";

void check_event_without_operation(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      const model::State& state = unit.states[s];
      if (unled(subject, unit, s) != Unled::no_operation) continue;
      const model::Symbol& symbol = event_of(plant, unit, state.event);
      diagnostics.add(
          rule.info, about(symbol),
          fmt::format("`{}` reports `{}` of `{}`, but no operation leads there: add an operation with task `{}`, or "
                      "number the tasks if it comes by itself{}",
                      symbol.name(), state.name, unit.path, state.name,
                      unit.described == nullptr ? "" : ", or describe a transition"),
          location_of(plant, symbol));
    }
  }
}

}  // namespace

const Rule kEventWithoutOperation{{"SP402", "event-without-operation", diag::Severity::warning,
                                   "a device reports a state that it can never reach", kEventWithoutOperationPage},
                                  check_event_without_operation};

}  // namespace symplant::check
