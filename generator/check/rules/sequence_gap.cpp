// SP411 sequence-gap: a sequence number is missing.
#include <fmt/format.h>

#include <algorithm>

#include "check/rules.hpp"
#include "check/spelling/sequence_numbers.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kSequenceGapPage =
    R"(The numbered tasks of a device skip a number: `P1`, `P2`, `P4`. Numbers in even steps (`10`, `20`, `30`) are no gap.

**What the model loses.** A state, if its rows are missing: the device steps from `P2` to `P4`, and a program that waits for `P3`
waits forever. Nothing, if only the number was skipped: the order stays the same.

**How to fix it.** Add the rows of the missing number, or number the tasks without a gap.
)";

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

}  // namespace

const Rule kSequenceGap{{"SP411", "sequence-gap", diag::Severity::warning, "a sequence number is missing",
                         kSequenceGapPage, diag::Rank::gap},
                        check_sequence_gap};

}  // namespace symplant::check
