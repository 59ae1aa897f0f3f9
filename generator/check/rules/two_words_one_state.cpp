// SP405 two-words-one-state: two words may mean one state.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kPage =
    R"(A device has exactly two tasks; one has only an operation, the other only an event: `O_CLAMP` and `I_CLAMPED`.

**What the model loses.** If both words mean one state, the device has one state too many: it goes to CLAMP and CLAMPED is
never reported. A program that waits for it waits for ever.

**How to mend it.** Spell both alike (`O_CLAMP`, `I_CLAMP`). If they are two states, add the operation or the event that is
missing.
)";

void check_two_words_one_state(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (!unit.two_words) continue;
    const model::Symbol& operation = operation_of(plant, unit, 0);
    const model::Symbol& event = event_of(plant, unit, 0);
    diagnostics.add(
        rule.info, about(event),
        fmt::format("`{}` and `{}`: do `{}` and `{}` mean one state? spell them alike, or `{}` is never reported",
                    operation.name(), event.name(), operation.reading.task, event.reading.task, event.reading.task),
        place_of(plant, event), {{place_of(plant, operation), "the operation"}});
  }
}

}  // namespace

const Rule kTwoWordsOneState{
    {"SP405", "two-words-one-state", diag::Severity::warning, "two words may mean one state", kPage},
    check_two_words_one_state};

}  // namespace symplant::check
