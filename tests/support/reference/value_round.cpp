// Jumps of values in a round, and values set by hand (docs/values.md, "Jumps").
#include <cmath>

#include "support/reference/material.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

/// Entries act in order: each sees its value as the one before left it. True if the output changed.
bool change_value(Round& round, std::uint32_t index) {
  const ValueRules& its = round.rules.values[index];
  ValueWorld& value = round.next.values[index];
  if (value.frozen) return false;
  const double before = round.old.values[index].outputs[0];
  const bool held = value.without_malfunctions.has_value();
  double output = before;
  int acted = 0;
  for (std::size_t i = 0; i < its.changes.size(); ++i) {
    const bool truth = holds(its.changes[i].when, Sight{round.rules, round.old});
    const bool began = truth && !value.truths[i];
    value.truths[i] = truth;
    if (!began) continue;
    ++acted;
    ++round.counters[Counted::value_jumped];
    const double result = evaluate(its.changes[i].to, {round.rules, round.old, index, output});
    if (std::isfinite(result) && held) {
      value.without_malfunctions = limited(its, result);
      ++round.counters[Counted::held_parameter_jumped];
    } else if (std::isfinite(result)) {
      output = limited(its, result);
    } else {
      value.not_finite = true;
      ++round.counters[Counted::jump_not_finite];
    }
  }
  if (acted > 1) ++round.counters[Counted::value_jumped_twice];
  value.outputs[0] = output;
  return output != before;
}

}  // namespace

bool change_values(Round& round, int number) {
  bool any = false;
  for (std::uint32_t i = 0; i < round.rules.values.size(); ++i) {
    if (!change_value(round, i)) continue;
    round.notes.steps[steppers(round.rules).values + i].push_back(number);
    any = true;
  }
  return any;
}

bool set_value(const Rules& rules, World& world, std::uint32_t index, double number, Counters& counters) {
  if (index >= rules.values.size() || !rules.values[index].can_be_set() || !std::isfinite(number)) return false;
  ValueWorld& value = world.values[index];
  if (value.without_malfunctions) {
    value.without_malfunctions = limited(rules.values[index], number);
    ++counters[Counted::held_parameter_set];
  } else {
    value.outputs[0] = limited(rules.values[index], number);
  }
  value.was_set = true;
  world.instant_pending = true;
  ++counters[Counted::value_set];
  return true;
}

}  // namespace symplant::reference
