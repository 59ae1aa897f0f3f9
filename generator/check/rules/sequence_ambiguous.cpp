// SP409 sequence-ambiguous: several states could come before a numbered one.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kSequenceAmbiguousPage =
    R"(A numbered state has an event and no operation. The device should reach it from the state with the next lower number, but
several states have that number.

**What the model loses.** Nothing leads to the state: its event never comes on by itself.

**How to fix it.** Give each state of the sequence a separate number, or add the operation.
)";

void check_sequence_ambiguous(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    for (const std::uint32_t state : evidence_of(subject, unit).ambiguous_sequence) {
      if (unit.reaches(state)) continue;  // by the description
      const model::Symbol& symbol = event_of(plant, unit, unit.states[state].event);
      diagnostics.add(
          rule.info,
          about(symbol)
              .following(device(unit.path))
              .following(model_of(unit.path))
              .following(missing(plant, unit.path, tables::Direction::operation, unit.states[state].name)),
          fmt::format("several states of `{}` could come before `{}`: nothing leads there; give each a separate "
                      "number",
                      unit.path, unit.states[state].name),
          location_of(plant, symbol));
    }
  }
}

}  // namespace

const Rule kSequenceAmbiguous{{"SP409", "sequence-ambiguous", diag::Severity::warning,
                               "several states could come before a numbered one", kSequenceAmbiguousPage},
                              check_sequence_ambiguous};

}  // namespace symplant::check
