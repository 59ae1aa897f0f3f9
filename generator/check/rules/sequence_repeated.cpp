// SP412 sequence-repeated: two tasks of a sequence have the same number.
#include <fmt/format.h>

#include "check/rules.hpp"
#include "check/spelling/sequence_numbers.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kSequenceRepeatedPage =
    R"(A device numbers its tasks, and two of them have the same number: `HOME1`, `JOB2`, `DONE2`. If several numbers repeat (`ADV1`,
`RET1`, `ADV2`, `RET2`), they count sensors and are no sequence.

**What the model loses.** The order. The rows decide which of the two comes first. A state that should follow them without an
operation, or is one of them, is not reached, or is reached from the wrong state.

**How to fix it.** Give each task of the sequence a separate number, or give its `transitions` in plant.json.
)";

/// The second of the only two states that share a number; nothing where none or more do.
const NumberedState* only_repeat(const std::vector<NumberedState>& states) {
  const NumberedState* repeat = nullptr;
  for (std::size_t i = 1; i < states.size(); ++i) {
    if (states[i].number != states[i - 1].number) continue;
    if (repeat != nullptr) return nullptr;
    repeat = &states[i];
  }
  return repeat;
}

bool gives_the_order(const model::Unit& unit) {
  return unit.described != nullptr && !unit.described->transitions.empty();
}

void check_sequence_repeated(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::vector<NumberedState> states;
  for (const model::Unit& unit : plant.units) {
    if (unit.states.size() < 3 || gives_the_order(unit)) continue;
    numbered_states(unit, states);
    if (states.size() < 3) continue;
    const NumberedState* second = only_repeat(states);
    if (second == nullptr) continue;
    const NumberedState* first = second - 1;
    const model::Symbol& symbol = plant.symbols[second->symbol];
    diagnostics.add(
        rule.info,
        about(symbol).explaining(device(unit.path)).following(device(unit.path)).following(model_of(unit.path)),
        fmt::format("`{}` and `{}` of `{}` have the same number: only their rows decide which comes first; "
                    "give each a separate number",
                    unit.states[first->state].name, unit.states[second->state].name, unit.path),
        location_of(plant, symbol), {{location_of(plant, plant.symbols[first->symbol]), "the other one"}});
  }
}

}  // namespace

const Rule kSequenceRepeated{
    {"SP412", "sequence-repeated", diag::Severity::warning, "two tasks of a sequence have the same number",
     kSequenceRepeatedPage, diag::Rank::repeated},
    check_sequence_repeated};

}  // namespace symplant::check
