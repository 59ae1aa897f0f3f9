// Findings at run time and requirements (docs/model.md, "What the plant finds").
#include "support/reference/findings.hpp"

#include <algorithm>

#include "support/reference/material.hpp"

namespace symplant::reference {
namespace {

using tables::FindingKind;

struct Finder {
  const Rules& rules;
  World& world;
  const InstantNotes& notes;
  Counters& counters;
  std::vector<tables::Finding> found;

  void add(FindingKind kind, std::uint32_t of, Counted counted, bool more = false) {
    ++counters[counted];
    found.push_back({world.time, of, kind, more});
  }
};

/// Since when each operation has been on while the unit was settled in the state that the operation leads to. True if
/// one has been for the unit's `overrun`.
bool runs_against_its_end(Finder& finder, std::uint32_t index) {
  const UnitRules& rules = finder.rules.units[index];
  UnitWorld& unit = finder.world.units[index];
  if (rules.overrun == tables::kNever) return false;
  bool overrun = false;
  for (std::uint32_t i = 0; i < rules.operations.size(); ++i) {
    OperationWorld& its = unit.operations[i];
    const bool at_end = is_on(finder.rules, finder.world, rules.operations[i]) && its.armed && !unit.disabled &&
                        !unit.frozen && !unit.moving && rules.leads_to(i, unit.state);
    if (!at_end) {
      if (its.at_end_since >= 0 && unit.disabled && !unit.overrun) {
        ++finder.counters[Counted::overrun_broken_by_disabling];
      }
      its.at_end_since = -1;
      continue;
    }
    if (its.at_end_since < 0 || its.at_end != unit.state) its.at_end_since = finder.world.time;
    its.at_end = unit.state;
    overrun = overrun || finder.world.time - its.at_end_since >= rules.overrun;
  }
  return overrun;
}

/// Raised when they become true; a frozen unit raises none.
void find_of_units(Finder& finder) {
  for (std::uint32_t i = 0; i < finder.world.units.size(); ++i) {
    const UnitRules& rules = finder.rules.units[i];
    UnitWorld& unit = finder.world.units[i];
    const Look& look = finder.notes.looks[i];
    const bool acts = !unit.disabled && !unit.frozen;
    bool some_operation = false;
    for (std::uint32_t j = 0; j < rules.operations.size(); ++j) {
      const bool on = is_on(finder.rules, finder.world, rules.operations[j]);
      some_operation = some_operation || (on && unit.operations[j].armed);
    }
    const bool conflicting = acts && look.conflicting;
    const bool stopped = acts && look.neither && some_operation;
    if (conflicting && !unit.conflicting) {
      finder.add(FindingKind::conflicting_operations, i, Counted::found_conflicting_operations);
    }
    if (stopped && !unit.stopped) {
      finder.add(FindingKind::stopped_under_another_command, i, Counted::found_stopped_under_another_command);
    }
    unit.conflicting = conflicting;
    unit.stopped = stopped;
    const bool overrun = runs_against_its_end(finder, i);
    if (overrun && !unit.overrun) finder.add(FindingKind::overrun, i, Counted::found_overrun);
    if (!overrun && unit.overrun) ++finder.counters[Counted::overrun_ended];
    unit.overrun = overrun;
    if (acts && finder.notes.enabled[i] && unit.moving && !unit.stopped_midway) {
      finder.add(FindingKind::started_on_enabling, i, Counted::found_started_on_enabling);
    }
  }
}

bool no_effect(const UnitRules& rules, const UnitWorld& unit, std::uint32_t operation) {
  if (unit.moving || rules.leads_to(operation, unit.state)) return false;
  for (const Transition& transition : rules.transitions) {
    if (transition.from == unit.state && transition.on == operation) return false;
  }
  return true;
}

/// An operation that rose in this instant and served nothing in it. True if there is a finding.
bool find_of_risen(Finder& finder, std::uint32_t index, std::uint32_t operation) {
  const UnitRules& rules = finder.rules.units[index];
  const UnitWorld& unit = finder.world.units[index];
  const std::uint32_t symbol = rules.operations[operation];
  if (unit.frozen) return false;
  if (unit.disabled) {
    finder.add(FindingKind::command_to_a_disabled_unit, symbol, Counted::found_command_to_a_disabled_unit);
    return true;
  }
  if (!no_effect(rules, unit, operation)) return false;
  finder.add(FindingKind::command_without_effect, symbol, Counted::found_command_without_effect);
  return true;
}

void find_of_operation(Finder& finder, std::uint32_t index, std::uint32_t operation) {
  const UnitRules& rules = finder.rules.units[index];
  UnitWorld& unit = finder.world.units[index];
  OperationWorld& its = unit.operations[operation];
  const SymbolWorld& symbol = finder.world.symbols[rules.operations[operation]];
  const bool on = is_on(finder.rules, finder.world, rules.operations[operation]);
  const bool was_on = finder.rules.turned(rules.operations[operation], symbol.shown) != 0;
  if (on != was_on && finder.rules.inverted[rules.operations[operation]]) {
    ++finder.counters[on ? Counted::inverted_operation_rose : Counted::inverted_operation_fell];
  }
  if (!on) {
    if (was_on && !its.had_finding && !its.served && !its.reached && !unit.frozen) {
      finder.add(FindingKind::lost_command, rules.operations[operation], Counted::found_lost_command);
    }
    its.served = its.had_finding = its.reached = false;
    return;
  }
  const bool served_now = finder.notes.served[index][operation];
  if (!was_on) {
    its.served = its.reached = false;
    its.had_finding = !served_now && find_of_risen(finder, index, operation);
  }
  its.served = its.served || served_now;
  its.reached = its.reached || rules.leads_to(operation, unit.target);
}

bool frozen(const Finder& finder, std::uint32_t symbol) {
  for (std::size_t i = 0; i < finder.rules.follows.size(); ++i) {
    if (finder.rules.follows[i].symbol == symbol) return finder.world.frozen_follows[i];
  }
  const std::uint32_t owner = finder.rules.model->symbols[symbol].unit;
  return owner != model::kNone && finder.world.units[owner].frozen;
}

void find_of_event(Finder& finder, std::uint32_t i) {
  SymbolWorld& symbol = finder.world.symbols[i];
  const bool on = is_on(finder.rules, finder.world, i);
  const bool was_on = finder.rules.turned(i, symbol.shown) != 0;
  // A frozen unit raises no findings, nor do its events, nor does a frozen symbol.
  if (finder.notes.event_changed[i] && on == was_on && !frozen(finder, i)) {
    finder.add(FindingKind::event_too_short, i, Counted::found_event_too_short);
  }
  const bool real_time = finder.world.cycle != 0;  // rises of a run without a cycle are not noted
  if (on && !was_on && real_time) symbol.rose = finder.world.time;
  const bool short_on = real_time && finder.world.time - symbol.rose < finder.world.cycle;
  if (!on && was_on && short_on && !frozen(finder, i)) {
    finder.add(FindingKind::event_too_short, i, Counted::found_event_too_short_real_time);
  }
}

/// Each loop's units in their order, then its symbols; the loops by their first units.
void find_of_loops(Finder& finder) {
  std::vector<std::vector<std::uint32_t>> loops = finder.notes.loops;
  std::sort(loops.begin(), loops.end());
  for (const std::vector<std::uint32_t>& loop : loops) {
    for (const std::uint32_t stepper : loop) {
      finder.add(FindingKind::instantaneous_loop, stepper, Counted::found_instantaneous_loop, stepper != loop.back());
    }
  }
}

void find_of_requirement(Finder& finder, std::uint32_t i) {
  const model::Requirement& rules = finder.rules.model->requirements[i];
  MonitorWorld& monitor = finder.world.monitors[i];
  const bool truth = holds(rules.condition, finder.world);
  const bool risen = truth && !monitor.truth;
  monitor.truth = truth;
  if (rules.kind == tables::RequirementRow::Kind::never) {
    if (!risen) return;
    ++finder.counters[Counted::never_violated];
    finder.add(FindingKind::requirement_violated, i, Counted::found_requirement_violated);
    return;
  }
  if (risen && !monitor.running) {
    ++finder.counters[Counted::watch_started];
    monitor.running = true;
    const Time now = finder.world.time;
    monitor.started = now;
    monitor.deadline = rules.within > tables::kNever - now ? tables::kNever : now + rules.within;
  }
  if (!monitor.running) return;
  if (holds(rules.expected, finder.world)) {
    const bool early = finder.world.time - monitor.started < rules.earliest;
    ++finder.counters[early ? Counted::watch_met_early : Counted::watch_met];
    if (early) finder.add(FindingKind::requirement_violated, i, Counted::found_requirement_violated);
  } else if (finder.world.time >= monitor.deadline) {
    ++finder.counters[Counted::watch_violated];
    finder.add(FindingKind::requirement_violated, i, Counted::found_requirement_violated);
  } else {
    return;
  }
  monitor.running = false;
  monitor.deadline = 0;
}

void find_of_transfer(Finder& finder, std::uint32_t i) {
  const bool blocked = is_blocked(finder.rules, finder.world, i);
  bool& before = finder.world.material.transfers[i].blocked;
  if (blocked && !before) finder.add(FindingKind::part_blocked, i, Counted::found_part_blocked);
  before = blocked;
}

void find_of_value(Finder& finder, std::uint32_t i) {
  ValueWorld& value = finder.world.values[i];
  if (value.frozen) value.not_finite = false;
  if (value.not_finite && !value.shown_not_finite) {
    finder.add(FindingKind::value_not_finite, i, Counted::found_value_not_finite);
  }
  if (!value.not_finite && value.shown_not_finite) ++finder.counters[Counted::value_finite_again];
  value.shown_not_finite = value.not_finite;
}

}  // namespace

std::vector<tables::Finding> findings_of(const Rules& rules, World& world, const InstantNotes& notes,
                                         Counters& counters) {
  Finder finder{rules, world, notes, counters, {}};
  find_of_units(finder);
  for (std::uint32_t i = 0; i < rules.units.size(); ++i) {
    for (std::uint32_t j = 0; j < rules.units[i].operations.size(); ++j) find_of_operation(finder, i, j);
  }
  for (std::uint32_t i = 0; i < world.symbols.size(); ++i) {
    if (!rules.is_operation(i) && rules.is_bool(i)) find_of_event(finder, i);
  }
  find_of_loops(finder);
  for (std::uint32_t i = 0; i < world.monitors.size(); ++i) find_of_requirement(finder, i);
  for (std::uint32_t i = 0; i < world.material.transfers.size(); ++i) find_of_transfer(finder, i);
  for (std::uint32_t i = 0; i < world.values.size(); ++i) find_of_value(finder, i);
  // In the order of the table in docs/model.md, then by unit, symbol or requirement. Loops are in order already.
  std::stable_sort(finder.found.begin(), finder.found.end(), [](const tables::Finding& a, const tables::Finding& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    return a.kind != FindingKind::instantaneous_loop && a.of < b.of;
  });
  return finder.found;
}

}  // namespace symplant::reference
