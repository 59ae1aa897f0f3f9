// SP402 event-without-operation: no operation leads to the state of an event.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kEventWithoutOperationPage =
    R"(A device has an event for a task, but no operation for it, and nothing else that was inferred leads there: it is neither
the rest state of a spring nor the next one of a numbered sequence. Devices of one type (`CLAMP1`, `CLAMP2`) make one finding;
its related rows are the other symbols.

**What the model loses.** The event never comes on by itself. A program that waits for it waits forever.

**How to fix it.** Add the operation, spell both tasks alike, or number the tasks in their order (`IDLE1`, `RUN2`) if the
device goes on to this one by itself. Or describe a transition to the state in plant.json. For a further
sensor of a position that has one (`ADV1`, `ADV2`), switch its event on with `outputs`.
)";

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

}  // namespace

const Rule kEventWithoutOperation{{"SP402", "event-without-operation", diag::Severity::warning,
                                   "no operation leads to the state of an event", kEventWithoutOperationPage},
                                  check_event_without_operation};

}  // namespace symplant::check
