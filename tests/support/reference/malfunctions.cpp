// What starts and ends malfunctions in the reference.
#include "support/reference/malfunctions.hpp"

#include <algorithm>

#include "support/reference/material.hpp"

namespace symplant::reference {
namespace {

using engine::MalfunctionChange;
using By = MalfunctionChange::By;
using tables::MalfunctionKind;

/// Draw of a time that may be random, of a stream: 0 (chance), 1 (lasts), or 2 and the number of an effect (every);
/// from now.
Time in(const Rules& rules, World& world, std::uint32_t number, std::uint64_t stream, std::uint32_t& draws,
        const std::optional<description::Duration>& duration) {
  if (!duration) return tables::kNever;
  Time time = duration->a;
  if (duration->kind != description::Duration::Kind::fixed) {
    time = draw_duration(world.seed, rules.model->malfunctions[number].name, stream, draws++, *duration);
  }
  return later(world.time, std::max<Time>(1, time));
}

Time by_chance(const Rules& rules, World& world, std::uint32_t number) {
  std::uint32_t& draws = world.malfunctions.written[number].draws[0];
  return in(rules, world, number, 0, draws, rules.model->malfunctions[number].chance);
}

Time next_flicker(const Rules& rules, World& world, std::uint32_t number, std::size_t effect) {
  std::uint32_t& draws = world.malfunctions.written[number].effects[effect].draws;
  return in(rules, world, number, 2 + effect, draws, rules.model->malfunctions[number].effects[effect].every);
}

void count_start(const Rules& rules, std::uint32_t number, By by, Counters& counters) {
  static constexpr std::array kBy = {Counted::started_by_scenario, Counted::started_by_hand,
                                     Counted::started_by_condition, Counted::started_by_chance,
                                     Counted::started_by_becoming};
  ++counters[kBy[static_cast<std::size_t>(by)]];
  if (!is_written(rules, number)) {
    ++counters[Counted::ordinary_started];
    return;
  }
  const model::Malfunction& it = rules.model->malfunctions[number];
  if (it.during && by == By::condition) ++counters[Counted::while_started];
  if (it.effects.size() > 1) ++counters[Counted::several_effects_started];
  for (const model::Effect& effect : it.effects) {
    if (effect.kind == MalfunctionKind::lose) ++counters[Counted::lose_started];
  }
}

void count_end(const Rules& rules, std::uint32_t number, By by, Counters& counters) {
  if (by == By::scenario || by == By::hand) ++counters[Counted::stopped_by_hand];
  const bool during = is_written(rules, number) && rules.model->malfunctions[number].during;
  if (by == By::condition) ++counters[during ? Counted::while_ended : Counted::remedied];
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

/// False if none is due.
bool flicker(const Rules& rules, World& world, std::uint32_t number, Counters& counters) {
  const model::Malfunction& it = rules.model->malfunctions[number];
  MalfunctionWorld& its = world.malfunctions.written[number];
  bool any = false;
  for (std::size_t i = 0; i < its.begun; ++i) {
    EffectWorld& effect = its.effects[i];
    if (effect.flickers > world.time) continue;
    any = true;
    effect.shows_opposite = !effect.shows_opposite;
    effect.flickers =
        effect.shows_opposite ? later(world.time, it.effects[i].shows) : next_flicker(rules, world, number, i);
    override_symbols(rules, world);
    ++counters[Counted::flickered];
    const SymbolWorld& symbol = world.symbols[it.effects[i].subject];
    if (symbol.forced) ++counters[Counted::flickered_below_a_force];
    if (effect.shows_opposite && symbol.broken.kind == SymbolOverride::Kind::value) {
      ++counters[Counted::flickered_above_another];
    }
  }
  return any;
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
  } else if (its.active && flicker(rules, world, number, counters)) {
    return;
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

std::vector<model::Effect> effects_of(const Rules& rules, std::uint32_t number) {
  const std::vector<model::Malfunction>& written = rules.model->malfunctions;
  if (number < written.size()) return written[number].effects;
  number -= static_cast<std::uint32_t>(written.size());
  const auto units = static_cast<std::uint32_t>(rules.units.size());
  model::Effect effect;
  if (number < 2 * units) {
    effect.kind = number % 2 == 0 ? MalfunctionKind::stuck : MalfunctionKind::slower;
    effect.factor = 3000;
    effect.units = {{number / 2, tables::kNoState}};
  } else {
    number -= 2 * units;
    effect.kind = MalfunctionKind::force;
    effect.forces = {{number / 2, number % 2, false}};
  }
  return {effect};
}

void reset_malfunctions(const Rules& rules, World& world) {
  const std::vector<model::Malfunction>& written = rules.model->malfunctions;
  world.malfunctions = {};
  world.malfunctions.written.resize(written.size());
  for (std::uint32_t i = 0; i < written.size(); ++i) {
    world.malfunctions.written[i].effects.resize(written[i].effects.size());
    world.malfunctions.written[i].chance = by_chance(rules, world, i);
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
  const bool written = is_written(rules, number);
  if (written && world.malfunctions.written[number].frozen) {
    ++counters[Counted::frozen_malfunction_started];
    return;
  }
  count_start(rules, number, by, counters);
  if (written) count_change(world, number);
  world.malfunctions.active.push_back({number, world.time});
  if (written) {
    const model::Malfunction& it = rules.model->malfunctions[number];
    MalfunctionWorld& its = world.malfunctions.written[number];
    its.active = true;
    its.since = world.time;
    its.chance = tables::kNever;
    its.wants_start = its.wants_end = false;
    its.ends = in(rules, world, number, 1, its.draws[1], it.lasts);
    if (it.after != 0) its.becomes = later(world.time, it.after);
    for (std::size_t i = 0; i < it.effects.size(); ++i) {
      begin_effect(rules, world, number, i, counters);
      if (it.effects[i].kind == MalfunctionKind::flicker)
        its.effects[i].flickers = next_flicker(rules, world, number, i);
    }
  }
  if (!written) count_units(effects_of(rules, number).front(), world, counters);
  override_symbols(rules, world);
  count_layers(rules, world, counters);
  world.instant_pending = true;
  changes.push_back({number, true, by});
}

void end_malfunction(const Rules& rules, World& world, std::uint32_t number, By by, Counters& counters,
                     std::vector<MalfunctionChange>& changes) {
  if (!is_active(world, number)) return;
  const bool written = is_written(rules, number);
  count_end(rules, number, by, counters);
  if (written) count_change(world, number);
  std::erase_if(world.malfunctions.active, [&](const ActiveWorld& one) { return one.number == number; });
  if (written) {
    MalfunctionWorld& its = world.malfunctions.written[number];
    its.active = its.wants_end = false;
    its.begun = 0;
    for (EffectWorld& effect : its.effects) {
      effect.flickers = tables::kNever;
      effect.shows_opposite = false;
    }
    its.since = 0;
    its.ends = its.becomes = tables::kNever;
    its.chance = by_chance(rules, world, number);
    const bool outside = by == By::scenario || by == By::hand;
    its.stopped = outside && rules.model->malfunctions[number].during;
    if (its.stopped) ++counters[Counted::while_waits];
  }
  const std::vector<model::Effect> effects = effects_of(rules, number);
  // A unit that nothing else disables is enabled by the end, not by a `disables`.
  for (std::uint32_t unit = 0; unit < world.units.size(); ++unit) {
    UnitWorld& its = world.units[unit];
    const bool was_stuck = std::any_of(effects.begin(), effects.end(), [&](const model::Effect& effect) {
      return effect.kind == MalfunctionKind::stuck && names_unit(effect, unit);
    });
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
    if (it.during) {
      if (!truth) its.stopped = false;
      its.wants_start = truth && !its.active && !its.stopped && !its.frozen;
      its.wants_end = !truth && its.active;
    } else if (begins && !its.active && !its.frozen) {
      its.wants_start = its.by_condition_at != world.time;
      if (!its.wants_start) ++counters[Counted::started_once_at_a_time];
    }
    if (it.unless) its.wants_end = its.active && holds(*it.unless, world);
    if (its.wants_start || its.wants_end) world.malfunctions.pending = world.instant_pending = true;
  }
}

Time next_due_of_malfunctions(const World& world) {
  Time due = tables::kNever;
  for (const MalfunctionWorld& its : world.malfunctions.written) due = std::min(due, its.next_due());
  return due;
}

}  // namespace symplant::reference
