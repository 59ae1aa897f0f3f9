// Rules: sequence numbers.
#include <fmt/format.h>

#include <algorithm>

#include "check/rules.hpp"
#include "check/spelling/sequence_numbers.hpp"

namespace symplant::check {
namespace {

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

/// The step from one number to the next, where most steps are alike and few numbers are missing; 0 else.
std::uint64_t step_of(const std::vector<NumberedState>& states) {
  if (states.size() < 3) return 0;
  std::uint64_t step = ~std::uint64_t{0};
  for (std::size_t i = 1; i < states.size(); ++i) {
    if (states[i].number != states[i - 1].number) step = std::min(step, states[i].number - states[i - 1].number);
  }
  std::size_t steps = 0;
  std::size_t even = 0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const std::uint64_t here = states[i].number - states[i - 1].number;
    if (here % step != 0) return 0;
    steps += here != 0 ? 1U : 0U;
    even += here == step ? 1U : 0U;
  }
  const std::uint64_t missing = (states.back().number - states.front().number) / step - steps;
  return missing != 0 && missing < states.size() && 2 * even >= steps ? step : 0;
}

void check_sequence_gap(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::vector<NumberedState> states;
  for (const model::Unit& unit : plant.units) {
    if (unit.states.size() < 3) continue;
    numbered_states(unit, states);
    const std::uint64_t step = step_of(states);
    for (std::size_t i = 1; step != 0 && i < states.size(); ++i) {
      const NumberedState& before = states[i - 1];
      const NumberedState& after = states[i];
      if (after.number - before.number <= step) continue;
      const model::Symbol& symbol = plant.symbols[after.symbol];
      const std::uint64_t first = before.number + step;
      const std::uint64_t last = after.number - step;
      diagnostics.add(
          rule.info,
          about(symbol)
              .explaining(sequence_of(unit.path))
              .explaining(model_of(unit.path))
              .following(device(unit.path))
              .following(model_of(unit.path)),
          fmt::format("`{}` steps from `{}` to `{}`: {}; add the missing rows, or number the tasks without a gap",
                      unit.path, unit.states[before.state].name, unit.states[after.state].name,
                      first == last ? fmt::format("number {} is missing", first)
                                    : fmt::format("numbers {} to {} are missing", first, last)),
          location_of(plant, symbol), {{location_of(plant, plant.symbols[before.symbol]), "the number before"}});
    }
  }
}

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

const Rule kSequenceAmbiguous{
    {"SP409", "sequence-ambiguous", diag::Severity::warning, "several states could come before a numbered one",
     R"(A numbered state has an event and no operation. The device should reach it from the state with the next lower number, but
several states have that number.

**What the model loses.** Nothing leads to the state: its event never comes on by itself.

**How to fix it.** Give each state of the sequence a separate number, or add the operation.
)"},
    check_sequence_ambiguous};

const Rule kSequenceGap{
    {"SP411", "sequence-gap", diag::Severity::warning, "a sequence number is missing",
     R"(The numbered tasks of a device skip a number: `P1`, `P2`, `P4`. Numbers in even steps (`10`, `20`, `30`) are no gap.

**What the model loses.** A state, if its rows are missing: the device steps from `P2` to `P4`, and a program that waits for `P3`
waits forever. Nothing, if only the number was skipped: the order stays the same.

**How to fix it.** Add the rows of the missing number, or number the tasks without a gap.
)",
     diag::Rank::gap},
    check_sequence_gap};

const Rule kSequenceRepeated{
    {"SP412", "sequence-repeated", diag::Severity::warning, "two tasks of a sequence have the same number",
     R"(A device numbers its tasks, and two of them have the same number: `HOME1`, `JOB2`, `DONE2`. If several numbers repeat (`ADV1`,
`RET1`, `ADV2`, `RET2`), they count sensors and are no sequence.

**What the model loses.** The order. The rows decide which of the two comes first. A state that should follow them without an
operation, or is one of them, is not reached, or is reached from the wrong state.

**How to fix it.** Give each task of the sequence a separate number, or give its `transitions` in plant.json.
)",
     diag::Rank::repeated},
    check_sequence_repeated};

}  // namespace symplant::check
