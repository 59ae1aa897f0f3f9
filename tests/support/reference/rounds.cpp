// The rounds of one instant: disables, the step of every unit, loops (docs/model.md, "One instant").
#include "support/reference/malfunctions.hpp"
#include "support/reference/material.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

constexpr int kFirstLimit = 200;
constexpr int kStepsOfLoop = 3;

void arm(Round& round) {
  for (std::uint32_t unit = 0; unit < round.old.units.size(); ++unit) {
    const UnitRules& rules = round.of(unit);
    for (std::uint32_t i = 0; i < rules.operations.size(); ++i) {
      OperationWorld& operation = round.next.units[unit].operations[i];
      if (operation.armed || is_on(round.rules, round.old, rules.operations[i])) continue;
      operation.armed = true;
      ++round.counters[Counted::rearmed];
      if (round.old.units[unit].disabled) ++round.counters[Counted::rearmed_while_disabled];
    }
  }
}

void note_events(const Rules& rules, const World& old, const World& next, Counters& counters, InstantNotes& notes) {
  for (std::uint32_t i = 0; i < old.symbols.size(); ++i) {
    if (rules.is_operation(i) || !rules.is_bool(i)) continue;
    if (effective(old.symbols[i]) != effective(next.symbols[i])) notes.event_changed[i] = true;
    if (old.symbols[i].value == next.symbols[i].value) continue;
    if (next.symbols[i].forced) ++counters[Counted::forced_event_differs];
    if (rules.inverted[i]) ++counters[Counted::inverted_event_switched];
  }
}

/// A time beyond the range never comes, and its remaining time does not count down. Stopped times are not
/// checked.
void never_comes(World& world) {
  const auto beyond = [&](Time left) { return left >= tables::kNever - world.time; };
  for (UnitWorld& unit : world.units) {
    if (unit.disabled || unit.frozen) continue;
    if (unit.moving && !unit.stopped_midway && beyond(unit.remaining)) unit.remaining = tables::kNever;
    for (TransitionWorld& transition : unit.transitions) {
      if (beyond(transition.left)) transition.left = tables::kNever;
    }
    if (beyond(unit.until_woken)) unit.until_woken = -1;
  }
}

/// True if something happened that requires another round.
bool run_round(const Rules& rules, World& world, int number, Counters& counters, InstantNotes& notes) {
  const World old = world;
  Round round{rules, old, world, counters, notes};
  notes.looks.assign(world.units.size(), {});
  bool again = false;
  arm(round);
  for (std::uint32_t unit = 0; unit < world.units.size(); ++unit) {
    if (!step(round, unit)) continue;
    notes.steps[unit].push_back(number);
    again = true;
  }
  if (follow_conditions(round, number)) again = true;
  if (run_material(round, number)) again = true;
  if (change_values(round, number)) again = true;
  never_comes(world);
  if (work_out_disabled(rules, world, counters, notes)) again = true;
  never_comes(world);  // for units that became enabled
  note_events(rules, old, world, counters, notes);
  return again;
}

void freeze_stepper(const Rules& rules, World& world, std::size_t stepper, Counters& counters) {
  const Steppers first = steppers(rules);
  if (stepper < world.units.size()) {
    world.units[stepper].frozen = true;
  } else if (stepper < first.tracks) {
    world.frozen_follows[stepper - world.units.size()] = true;
    ++counters[Counted::follow_frozen];
  } else if (stepper < first.work) {
    world.material.transfers[stepper - first.transfers].frozen = true;
    ++counters[Counted::transfer_frozen];
  } else if (stepper < first.sources) {
    world.material.work[stepper - first.work].frozen = true;
    ++counters[Counted::work_frozen];
  } else if (stepper < first.malfunctions) {
    world.material.sources[stepper - first.sources].frozen = true;
  } else {
    world.values[stepper - first.values].frozen = true;
    ++counters[Counted::value_frozen];
  }
}

/// Freezes all that stepped often in the second half of the rounds. False if none did.
bool freeze(const Rules& rules, World& world, int rounds, Counters& counters, InstantNotes& notes) {
  std::vector<std::uint32_t> loop;
  for (std::uint32_t stepper = 0; stepper < notes.steps.size(); ++stepper) {
    int steps = 0;
    for (const int round : notes.steps[stepper]) steps += round > rounds / 2 ? 1 : 0;
    if (steps >= kStepsOfLoop) loop.push_back(stepper);
  }
  if (loop.empty()) return false;
  for (const std::uint32_t stepper : loop) freeze_stepper(rules, world, stepper, counters);
  for (std::vector<int>& steps : notes.steps) steps.clear();
  notes.loops.push_back(loop);
  ++counters[Counted::loop_frozen];
  return true;
}

}  // namespace

bool work_out_disabled(const Rules& rules, World& world, Counters& counters, InstantNotes& notes) {
  bool changed = false;
  for (std::uint32_t unit = 0; unit < world.units.size(); ++unit) {
    bool disabled = false;
    for (std::uint32_t by = 0; by < world.units.size(); ++by) {
      if (by == unit || world.units[by].moving) continue;
      for (const std::uint32_t other : rules.units[by].states[world.units[by].state].disables) {
        disabled = disabled || other == unit;
      }
    }
    UnitWorld& its = world.units[unit];
    its.disabled_by_units = disabled;
    disabled = disabled || is_stuck(rules, world, unit);
    if (its.disabled == disabled) continue;
    changed = true;
    its.disabled = disabled;
    ++counters[disabled ? Counted::unit_disabled : Counted::unit_enabled];
    if (!disabled) notes.enabled[unit] = true;
    if (!disabled) continue;
    for (const TransitionWorld& transition : its.transitions) {
      if (transition.holds && transition.left > 0) ++counters[Counted::after_kept_while_disabled];
    }
  }
  return changed;
}

void run_rounds(const Rules& rules, World& world, Counters& counters, InstantNotes& notes) {
  work_out_disabled(rules, world, counters, notes);
  never_comes(world);
  int limit = kFirstLimit;
  for (int number = 1; run_round(rules, world, number, counters, notes); ++number) {
    if (number != limit) continue;
    if (freeze(rules, world, limit, counters, notes)) {
      number = 0;
      limit = kFirstLimit;
    } else {
      limit *= 2;
      ++counters[Counted::rounds_doubled];
    }
  }
}

}  // namespace symplant::reference
