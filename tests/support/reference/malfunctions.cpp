// What starts and ends malfunctions in the reference.
#include "support/reference/malfunctions.hpp"

#include <algorithm>

#include "support/reference/material.hpp"

namespace symplant::reference {
namespace {

using engine::MalfunctionChange;
using By = MalfunctionChange::By;
using tables::MalfunctionKind;

/// Draw of a time that may be random, of stream 0 (chance), 1 (lasts) or 2 (every); from now.
Time in(const Rules& rules, World& world, std::uint32_t number, std::uint64_t stream,
        const std::optional<description::Duration>& duration) {
  if (!duration) return tables::kNever;
  Time time = duration->a;
  if (duration->kind != description::Duration::Kind::fixed) {
    std::uint32_t& draws = world.malfunctions.written[number].draws[stream];
    time = draw_duration(world.seed, rules.model->malfunctions[number].name, stream, draws++, *duration);
  }
  return later(world.time, std::max<Time>(1, time));
}

void count_start(const MalfunctionRules& it, By by, Counters& counters) {
  static constexpr std::array kBy = {Counted::started_by_scenario, Counted::started_by_hand,
                                     Counted::started_by_condition, Counted::started_by_chance,
                                     Counted::started_by_becoming};
  ++counters[kBy[static_cast<std::size_t>(by)]];
  if (it.written == nullptr) ++counters[Counted::ordinary_started];
  if (it.kind == MalfunctionKind::lose) ++counters[Counted::lose_started];
}

void count_end(By by, Counters& counters) {
  if (by == By::scenario || by == By::hand) ++counters[Counted::stopped_by_hand];
  if (by == By::condition) ++counters[Counted::remedied];
  if (by == By::end) ++counters[Counted::lasted];
}

/// A start or an end of a written one.
void count_change(World& world, std::uint32_t number) {
  MalfunctionsWorld& all = world.malfunctions;
  if (all.window < 0 || world.time - all.window >= tables::kMillisecond) {
    all.window = world.time;
    all.changes = 0;
    for (MalfunctionWorld& each : all.written) each.changes = 0;
  }
  ++all.changes;
  ++all.written[number].changes;
}

void freeze_loop(const Rules& rules, World& world, Counters& counters, std::vector<MalfunctionChange>& changes,
                 InstantNotes& notes) {
  constexpr int kMostChanges = 10'000;
  constexpr int kChangesOfLoop = 3;
  if (world.malfunctions.changes <= kMostChanges) return;
  std::vector<std::uint32_t> loop;
  for (std::uint32_t i = 0; i < world.malfunctions.written.size(); ++i) {
    MalfunctionWorld& its = world.malfunctions.written[i];
    if (its.frozen || its.changes < kChangesOfLoop) continue;
    if (its.active) end_malfunction(rules, world, i, By::end, counters, changes);
    its.frozen = true;
    its.chance = tables::kNever;
    its.wants_start = false;
    loop.push_back(static_cast<std::uint32_t>(steppers(rules).malfunctions) + i);
    ++counters[Counted::malfunction_frozen];
  }
  if (!loop.empty()) notes.loops.push_back(loop);
}

void flicker(const Rules& rules, World& world, std::uint32_t number, Counters& counters) {
  const model::Malfunction& it = rules.model->malfunctions[number];
  MalfunctionWorld& its = world.malfunctions.written[number];
  its.shows_opposite = !its.shows_opposite;
  its.flickers = its.shows_opposite ? later(world.time, it.shows) : in(rules, world, number, 2, it.every);
  override_symbols(rules, world);
  ++counters[Counted::flickered];
  const SymbolWorld& symbol = world.symbols[it.subject];
  if (symbol.forced) ++counters[Counted::flickered_below_a_force];
  if (its.shows_opposite && symbol.broken.kind == SymbolOverride::Kind::value) {
    ++counters[Counted::flickered_above_another];
  }
}

/// Of one malfunction at most one of these happens in an instant.
void begin_one(const Rules& rules, World& world, std::uint32_t number, Counters& counters,
               std::vector<MalfunctionChange>& changes) {
  MalfunctionWorld& its = world.malfunctions.written[number];
  const bool wants_start = its.wants_start;
  const bool wants_end = its.wants_end;
  its.wants_start = its.wants_end = false;
  if (its.active && wants_end) {
    end_malfunction(rules, world, number, By::condition, counters, changes);
  } else if (its.active && its.ends <= world.time) {
    end_malfunction(rules, world, number, By::end, counters, changes);
  } else if (its.active && its.becomes <= world.time) {
    end_malfunction(rules, world, number, By::becomes, counters, changes);
    start_malfunction(rules, world, rules.model->malfunctions[number].next, By::becomes, counters, changes);
  } else if (its.active && its.flickers <= world.time) {
    flicker(rules, world, number, counters);
  } else if (!its.active && its.chance <= world.time) {
    start_malfunction(rules, world, number, By::chance, counters, changes);
  } else if (!its.active && wants_start) {
    its.by_condition_at = world.time;
    start_malfunction(rules, world, number, By::condition, counters, changes);
  }
}

void count_layers(const Rules& rules, World& world, Counters& counters) {
  for (std::uint32_t i = 0; i < world.symbols.size(); ++i) {
    const SymbolWorld& symbol = world.symbols[i];
    if (symbol.broken.kind != SymbolOverride::Kind::value) continue;
    if (symbol.forced) ++counters[Counted::force_hides_malfunction];
    if (rules.is_operation(i)) ++counters[Counted::operation_broken];
    if (!rules.is_bool(i)) ++counters[Counted::number_broken];
    if (rules.inverted[i]) ++counters[Counted::inverted_broken];
  }
}

}  // namespace

bool malfunction_exists(const Rules& rules, std::uint32_t number) {
  const std::size_t first_of_symbols = rules.model->malfunctions.size() + 2 * rules.units.size();
  if (number < first_of_symbols) return true;
  const std::size_t symbol = (number - first_of_symbols) / 2;
  if (symbol >= rules.model->symbols.size()) return false;
  const auto of = static_cast<std::uint32_t>(symbol);
  return rules.is_bool(of) && !rules.is_operation(of);
}

MalfunctionRules malfunction_of(const Rules& rules, std::uint32_t number) {
  const std::vector<model::Malfunction>& written = rules.model->malfunctions;
  if (number < written.size()) return {written[number].kind, &written[number], kNone, false};
  number -= static_cast<std::uint32_t>(written.size());
  const auto units = static_cast<std::uint32_t>(rules.units.size());
  if (number < 2 * units) {
    return {number % 2 == 0 ? MalfunctionKind::stuck : MalfunctionKind::slower, nullptr, number / 2, false};
  }
  number -= 2 * units;
  return {MalfunctionKind::force, nullptr, number / 2, number % 2 == 1};
}

void reset_malfunctions(const Rules& rules, World& world) {
  const std::vector<model::Malfunction>& written = rules.model->malfunctions;
  world.malfunctions = {};
  world.malfunctions.written.resize(written.size());
  for (std::uint32_t i = 0; i < written.size(); ++i) {
    world.malfunctions.written[i].chance = in(rules, world, i, 0, written[i].chance);
  }
}

bool is_active(const World& world, std::uint32_t number) {
  return std::any_of(world.malfunctions.active.begin(), world.malfunctions.active.end(),
                     [&](const ActiveWorld& one) { return one.number == number; });
}

void start_malfunction(const Rules& rules, World& world, std::uint32_t number, By by, Counters& counters,
                       std::vector<MalfunctionChange>& changes) {
  if (is_active(world, number)) {
    ++counters[Counted::started_while_active];
    return;
  }
  const MalfunctionRules it = malfunction_of(rules, number);
  if (it.written != nullptr && world.malfunctions.written[number].frozen) {
    ++counters[Counted::frozen_malfunction_started];
    return;
  }
  count_start(it, by, counters);
  if (it.written != nullptr) count_change(world, number);
  world.malfunctions.active.push_back({number, world.time});
  if (it.written != nullptr) {
    MalfunctionWorld& its = world.malfunctions.written[number];
    its.active = true;
    its.since = world.time;
    its.chance = tables::kNever;
    its.wants_start = its.wants_end = false;
    its.ends = in(rules, world, number, 1, it.written->lasts);
    if (it.written->after != 0) its.becomes = later(world.time, it.written->after);
    if (it.kind == MalfunctionKind::flicker) its.flickers = in(rules, world, number, 2, it.written->every);
  }
  for (std::uint32_t unit = 0; unit < world.units.size(); ++unit) {
    if (!it.names_unit(unit)) continue;
    const UnitWorld& its = world.units[unit];
    if (it.kind == MalfunctionKind::slower) {
      if (its.moving) ++counters[Counted::slower_starts_during_a_move];
      continue;
    }
    ++counters[its.moving ? Counted::stuck_moving : its.disabled ? Counted::stuck_disabled : Counted::stuck_settled];
    if (it.written == nullptr) continue;
    for (const tables::MalfunctionUnit& named : it.written->units) {
      if (named.unit != unit || named.state == tables::kNoState) continue;
      put_into_state(rules, world, unit, named.state, counters);
      ++counters[Counted::stuck_in_a_state];
    }
  }
  override_symbols(rules, world);
  count_layers(rules, world, counters);
  world.instant_pending = true;
  changes.push_back({number, true, by});
}

void end_malfunction(const Rules& rules, World& world, std::uint32_t number, By by, Counters& counters,
                     std::vector<MalfunctionChange>& changes) {
  if (!is_active(world, number)) return;
  const MalfunctionRules it = malfunction_of(rules, number);
  count_end(by, counters);
  if (it.written != nullptr) count_change(world, number);
  std::erase_if(world.malfunctions.active, [&](const ActiveWorld& one) { return one.number == number; });
  if (it.written != nullptr) {
    MalfunctionWorld& its = world.malfunctions.written[number];
    its.active = its.shows_opposite = its.wants_end = false;
    its.since = 0;
    its.ends = its.becomes = its.flickers = tables::kNever;
    its.chance = in(rules, world, number, 0, it.written->chance);
  }
  // A unit that nothing else disables is enabled by the end, not by a `disables`.
  for (std::uint32_t unit = 0; unit < world.units.size(); ++unit) {
    UnitWorld& its = world.units[unit];
    const bool was_stuck = it.kind == MalfunctionKind::stuck && it.names_unit(unit);
    if (!was_stuck || is_stuck(rules, world, unit)) continue;
    if (its.disabled_by_units) {
      ++counters[Counted::stuck_ended_disabled];
    } else {
      its.disabled = false;
      if (its.moving) ++counters[Counted::stuck_ended_moving];
    }
  }
  override_symbols(rules, world);
  world.instant_pending = true;
  changes.push_back({number, false, by});
}

std::vector<MalfunctionChange> begin_instant_of_malfunctions(const Rules& rules, World& world, Counters& counters,
                                                             InstantNotes& notes) {
  std::vector<MalfunctionChange> changes;
  world.malfunctions.pending = false;
  for (std::uint32_t i = 0; i < world.malfunctions.written.size(); ++i) begin_one(rules, world, i, counters, changes);
  freeze_loop(rules, world, counters, changes, notes);
  return changes;
}

void end_instant_of_malfunctions(const Rules& rules, World& world, Counters& counters) {
  for (std::uint32_t i = 0; i < world.malfunctions.written.size(); ++i) {
    const model::Malfunction& it = rules.model->malfunctions[i];
    MalfunctionWorld& its = world.malfunctions.written[i];
    const bool truth = it.condition && holds(*it.condition, world);
    const bool begins = truth && !its.truth;
    its.truth = truth;
    if (begins && !its.active && !its.frozen) {
      its.wants_start = its.by_condition_at != world.time;
      if (!its.wants_start) ++counters[Counted::started_once_at_a_time];
    }
    its.wants_end = its.active && it.unless && holds(*it.unless, world);
    if (its.wants_start || its.wants_end) world.malfunctions.pending = world.instant_pending = true;
  }
}

Time next_due_of_malfunctions(const World& world) {
  Time due = tables::kNever;
  for (const MalfunctionWorld& its : world.malfunctions.written) due = std::min(due, its.next_due());
  return due;
}

}  // namespace symplant::reference
