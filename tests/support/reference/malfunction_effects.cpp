// What malfunctions do in the reference.
#include <algorithm>
#include <optional>

#include "support/reference/malfunctions.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

using tables::MalfunctionKind;

__extension__ using Wide = __int128;

Time times(Time time, std::uint32_t thousandths) {
  if (time == tables::kNever) return time;
  const Wide product = static_cast<Wide>(time) * thousandths / 1000;
  return static_cast<Time>(std::min<Wide>(product, tables::kNever));
}

bool is_one_of(const std::vector<std::uint32_t>& symbols, std::uint32_t symbol) {
  return std::find(symbols.begin(), symbols.end(), symbol) != symbols.end();
}

/// Calls `visit(effect, its changing state)` for all effects that have begun, in the order in which their malfunctions
/// started. Ordinary ones have no changing state.
template <class Visit>
void for_active(const Rules& rules, const World& world, Visit visit) {
  for (const ActiveWorld& one : world.malfunctions.active) {
    const std::vector<model::Effect> effects = effects_of(rules, one.number);
    if (!is_written(rules, one.number)) {
      visit(effects.front(), EffectWorld{});
      continue;
    }
    const MalfunctionWorld& its = world.malfunctions.written[one.number];
    for (std::size_t i = 0; i < its.begun; ++i) visit(effects[i], its.effects[i]);
  }
}

/// The same for written ones, in the order of the description; with the time since the start.
template <class Visit>
void for_described(const Rules& rules, const World& world, Visit visit) {
  for (std::uint32_t i = 0; i < world.malfunctions.written.size(); ++i) {
    const MalfunctionWorld& its = world.malfunctions.written[i];
    for (std::size_t e = 0; e < its.begun; ++e) visit(rules.model->malfunctions[i].effects[e], world.time - its.since);
  }
}

/// What one effect makes of a symbol that is `now`.
SymbolOverride overridden(const model::Effect& effect, const EffectWorld& its,
                          const std::vector<std::uint32_t>& together, SymbolOverride now) {
  using Kind = SymbolOverride::Kind;
  for (std::size_t f = 0; f < effect.forces.size(); ++f) {
    const tables::MalfunctionForce& force = effect.forces[f];
    if (is_one_of(together, force.symbol)) now = {Kind::value, force.holds ? its.held[f] : force.value};
  }
  if (effect.kind == MalfunctionKind::flicker && is_one_of(together, effect.subject) && its.shows_opposite) {
    if (now.kind == Kind::value) return {Kind::value, now.value ^ 1};
    return {now.kind == Kind::none ? Kind::opposite : Kind::none, 0};
  }
  return now;
}

/// A parameter has the number of the effect that began last, or the one that it would have.
void override_parameters(const Rules& rules, World& world) {
  for (std::uint32_t v = 0; v < world.values.size(); ++v) {
    if (rules.values[v].kind != tables::ValueKind::parameter) continue;
    std::optional<double> number;
    for_active(rules, world, [&](const model::Effect& effect, const EffectWorld&) {
      for (const tables::MalfunctionSet& set : effect.sets) {
        if (set.value == v) number = set.number;
      }
    });
    ValueWorld& value = world.values[v];
    if (number && !value.without_malfunctions) value.without_malfunctions = value.outputs[0];
    if (number) value.outputs[0] = limited(rules.values[v], *number);
    if (!number && value.without_malfunctions) value.outputs[0] = *value.without_malfunctions;
    if (!number) value.without_malfunctions.reset();
  }
}

/// A written `slower` or `stuck` that begins acts on a unit.
void count_unit(const model::Effect& effect, const UnitWorld& its, Counters& counters) {
  if (effect.kind == MalfunctionKind::slower) {
    if (its.moving) ++counters[Counted::slower_starts_during_a_move];
    return;
  }
  ++counters[its.moving ? Counted::stuck_moving : its.disabled ? Counted::stuck_disabled : Counted::stuck_settled];
}

}  // namespace

void count_units(const model::Effect& effect, const World& world, Counters& counters) {
  for (const tables::MalfunctionUnit& named : effect.units) count_unit(effect, world.units[named.unit], counters);
}

bool names_unit(const model::Effect& effect, std::uint32_t unit) {
  return std::any_of(effect.units.begin(), effect.units.end(),
                     [&](const tables::MalfunctionUnit& named) { return named.unit == unit; });
}

void begin_effect(const Rules& rules, World& world, std::uint32_t number, std::size_t index, Counters& counters) {
  MalfunctionWorld& its = world.malfunctions.written[number];
  const model::Effect& effect = rules.model->malfunctions[number].effects[index];
  its.effects[index].held.clear();
  for (const tables::MalfunctionForce& force : effect.forces) {
    its.effects[index].held.push_back(force.holds ? effective(world.symbols[force.symbol]) : 0);
    if (force.holds) ++counters[Counted::held];
  }
  its.begun = index + 1;
  count_units(effect, world, counters);
  for (const tables::MalfunctionUnit& named : effect.units) {
    if (named.state == tables::kNoState) continue;
    put_into_state(rules, world, named.unit, named.state, counters);
    ++counters[Counted::stuck_in_a_state];
  }
  if (!effect.tracks.empty()) ++counters[Counted::track_broken];
  if (!effect.sets.empty()) ++counters[Counted::parameter_held];
  if (effect.kind == MalfunctionKind::distort) ++counters[Counted::distorted];
  override_symbols(rules, world);
}

bool is_stuck(const Rules& rules, const World& world, std::uint32_t unit) {
  bool stuck = false;
  for_active(rules, world, [&](const model::Effect& effect, const EffectWorld&) {
    stuck = stuck || (effect.kind == MalfunctionKind::stuck && names_unit(effect, unit));
  });
  return stuck;
}

Time slowed(const Rules& rules, const World& world, std::uint32_t unit, Time time, Counters& counters) {
  const Time without = time;
  int slower = 0;
  const auto slow = [&](const model::Effect& effect, Counted counted) {
    if (effect.kind != MalfunctionKind::slower || !names_unit(effect, unit)) return;
    time = times(time, effect.factor);
    ++slower;
    ++counters[counted];
  };
  for_described(rules, world, [&](const model::Effect& effect, Time) { slow(effect, Counted::slow_by_written); });
  for (const ActiveWorld& one : world.malfunctions.active) {
    if (is_written(rules, one.number)) continue;
    for (const model::Effect& effect : effects_of(rules, one.number)) slow(effect, Counted::slow_by_ordinary);
  }
  if (slower > 1) ++counters[Counted::slow_by_several];
  if (without != 0 && time == 0) ++counters[Counted::slower_takes_nothing];
  return time;
}

bool overrides_one_of(const Rules& rules, std::uint32_t number, const std::vector<std::uint32_t>& symbols) {
  const std::vector<model::Effect> effects = effects_of(rules, number);
  return std::any_of(effects.begin(), effects.end(), [&](const model::Effect& effect) {
    if (effect.kind == MalfunctionKind::flicker && is_one_of(symbols, effect.subject)) return true;
    return std::any_of(effect.forces.begin(), effect.forces.end(),
                       [&](const tables::MalfunctionForce& force) { return is_one_of(symbols, force.symbol); });
  });
}

void override_symbols(const Rules& rules, World& world) {
  for (std::uint32_t i = 0; i < world.symbols.size(); ++i) {
    const std::vector<std::uint32_t> together = rules.together(i);
    SymbolOverride to;
    for_active(rules, world, [&](const model::Effect& effect, const EffectWorld& its) {
      to = overridden(effect, its, together, to);
    });
    world.symbols[i].broken = to;
  }
  override_parameters(rules, world);
}

std::int64_t slowed_drive(const Rules& rules, const World& world, std::uint32_t track, std::int64_t speed) {
  for_described(rules, world, [&](const model::Effect& effect, Time) {
    if (std::find(effect.tracks.begin(), effect.tracks.end(), track) == effect.tracks.end()) return;
    if (effect.kind == MalfunctionKind::stuck) {
      speed = 0;
      return;
    }
    const Wide slower = static_cast<Wide>(speed) * 1000 / static_cast<Wide>(effect.factor);
    speed = static_cast<std::int64_t>(std::clamp<Wide>(slower, -tables::kMaxSpeed, tables::kMaxSpeed));
  });
  return speed;
}

double distorted(const Rules& rules, const World& world, std::uint32_t symbol, double number, Counters& counters) {
  for_described(rules, world, [&](const model::Effect& effect, Time since) {
    if (effect.kind != MalfunctionKind::distort || rules.model->signals[effect.subject].row.symbol != symbol) return;
    const double seconds = static_cast<double>(since) / 1e9;
    number = number * effect.distort.gain + effect.distort.offset + effect.distort.drift * seconds;
    ++counters[Counted::signal_distorted];
  });
  return number;
}

}  // namespace symplant::reference
