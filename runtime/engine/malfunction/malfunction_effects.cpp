// What malfunctions do: slow and stop units, override symbols.
#include <algorithm>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/malfunction/malfunctions.hpp"
#include "symplant/engine/wide.hpp"

namespace symplant::engine {
namespace {

using tables::MalfunctionKind;

/// `time` times a factor in thousandths, rounded down. A time that never comes stays so.
tables::Time times(tables::Time time, std::uint32_t factor) noexcept {
  if (time == tables::kNever) return time;
  const Wide product = static_cast<Wide>(time) * factor / 1000;
  return product > static_cast<Wide>(tables::kNever) ? tables::kNever : static_cast<tables::Time>(product);
}

}  // namespace

/// The effects of a written one begin in their order.
void Malfunctions::affect(std::uint32_t number) noexcept {
  if (!numbers_.is_written(number)) {
    const MalfunctionKind kind = numbers_.ordinary_kind(number);
    if (kind == MalfunctionKind::force) return override_again(numbers_.symbol(number));
    return kind == MalfunctionKind::stuck ? stick(numbers_.unit(number), tables::kNoState)
                                          : slow(numbers_.unit(number));
  }
  const std::span<const tables::EffectRow> effects = tables_.malfunctions.effects_of(number);
  for (std::uint32_t e = 0; e < effects.size(); ++e) {
    hold(effects[e]);
    states_[number].begun = e + 1;
    if (effects[e].kind == MalfunctionKind::flicker) effect_state(number, e).due = next_flicker(number, e);
    affect(effects[e]);
  }
}

void Malfunctions::affect(const tables::EffectRow& effect) noexcept {
  for (const tables::MalfunctionUnit& of : tables_.malfunctions.units_of(effect)) {
    effect.kind == MalfunctionKind::stuck ? stick(of.unit, of.state) : slow(of.unit);
  }
  for (const tables::MalfunctionForce& force : tables_.malfunctions.forces_of(effect)) override_again(force.symbol);
  count_effect(effect, 1);
  set_again(effect);
}

void Malfunctions::release(std::uint32_t number) noexcept {
  if (!numbers_.is_written(number)) {
    const MalfunctionKind kind = numbers_.ordinary_kind(number);
    if (kind == MalfunctionKind::stuck) unstick(numbers_.unit(number));
    if (kind == MalfunctionKind::force) override_again(numbers_.symbol(number));
    return;
  }
  states_[number].begun = 0;
  const std::span<const tables::EffectRow> effects = tables_.malfunctions.effects_of(number);
  for (std::uint32_t e = 0; e < effects.size(); ++e) {
    EffectState& state = effect_state(number, e);
    state.shows = 0;
    state.due = tables::kNever;
    release(effects[e]);
  }
}

void Malfunctions::release(const tables::EffectRow& effect) noexcept {
  if (effect.kind == MalfunctionKind::stuck) {
    for (const tables::MalfunctionUnit& of : tables_.malfunctions.units_of(effect)) unstick(of.unit);
  }
  for (const tables::MalfunctionForce& force : tables_.malfunctions.forces_of(effect)) override_again(force.symbol);
  if (effect.kind == MalfunctionKind::flicker) override_again(effect.subject);
  count_effect(effect, static_cast<std::uint32_t>(-1));
  set_again(effect);
}

/// Remembers what the events of an effect that begins show.
void Malfunctions::hold(const tables::EffectRow& effect) noexcept {
  for (const tables::MalfunctionForce& force : tables_.malfunctions.forces_of(effect)) {
    if (force.holds) holds_[&force - tables_.malfunctions.forces.data()] = shown(force.symbol);
  }
}

/// Counts the active effects of kinds that are looked for often, and wakes what they act on.
void Malfunctions::count_effect(const tables::EffectRow& effect, std::uint32_t change) noexcept {
  if (effect.kind == MalfunctionKind::distort) {
    head_->distorting += change;
    engine_.values_.wake_signal(effect.subject);
  }
  if (effect.tracks.count == 0) return;
  head_->on_tracks += change;
  for (const std::uint32_t track : tables_.malfunctions.tracks_of(effect)) engine_.flow_.drives_changed(track);
}

/// Gives parameters the numbers that all active ones together set: that of the one that started last.
void Malfunctions::set_again(const tables::EffectRow& effect) noexcept {
  for (const tables::MalfunctionSet& set : tables_.malfunctions.sets_of(effect)) {
    const double* number = nullptr;
    for (const ActiveMalfunction& a : active()) {
      if (!numbers_.is_written(a.number)) continue;
      for (const tables::EffectRow& other : active_effects(a.number)) {
        for (const tables::MalfunctionSet& one : tables_.malfunctions.sets_of(other)) {
          if (one.value == set.value) number = &one.number;
        }
      }
    }
    engine_.values_.hold(set.value, number);
  }
}

std::int64_t Malfunctions::slowed_drive(std::uint32_t track, std::int64_t speed) const noexcept {
  if (head_->on_tracks == 0) return speed;
  for (std::uint32_t m = 0; m < written_; ++m) {
    for (const tables::EffectRow& effect : active_effects(m)) {
      if (numbers_.names_track(effect, track)) speed = tables::slowed_drive(effect, speed);
    }
  }
  return speed;
}

bool Malfunctions::is_stuck(std::uint32_t unit) const noexcept {
  return std::any_of(active().begin(), active().end(), [&](const ActiveMalfunction& a) {
    return numbers_.acts_on(a.number, MalfunctionKind::stuck, unit);
  });
}

bool Malfunctions::is_cut(std::uint32_t controller) const noexcept {
  return std::any_of(active().begin(), active().end(),
                     [&](const ActiveMalfunction& a) { return numbers_.cuts(a.number, controller); });
}

void Malfunctions::stick(std::uint32_t unit, std::uint8_t state) noexcept {
  if (state != tables::kNoState) engine_.set_state(unit, state);
  if (tables_.units[unit].general != 0) ++engine_.general_state(unit).disabled_by;
  if ((engine_.units_[unit].flags & kDisabled) == 0) engine_.disable(unit);
  engine_.touch(unit);
}

/// A unit that nothing else disables is enabled at once: this is not reported as by the end of a `disables`.
void Malfunctions::unstick(std::uint32_t unit) noexcept {
  const bool disabled =
      tables_.units[unit].general != 0 ? --engine_.general_state(unit).disabled_by != 0 : is_stuck(unit);
  if (!disabled && (engine_.units_[unit].flags & kDisabled) != 0) engine_.enable(unit, 0);
  engine_.touch(unit);
}

/// The unit leaves the fast path, and its moves ask slowed() for their times.
void Malfunctions::slow(std::uint32_t unit) noexcept { engine_.units_[unit].flags |= kSlowed | kGeneral; }

tables::Time Malfunctions::slowed(std::uint32_t unit, const tables::UnitRow& unit_row, tables::Time time) noexcept {
  bool any = false;
  const auto slow_by = [&](std::uint32_t factor) {
    time = times(time, factor);
    any = true;
  };
  for (std::uint32_t m = 0; m < written_; ++m) {
    for (const tables::EffectRow& effect : active_effects(m)) {
      if (effect.kind == MalfunctionKind::slower && numbers_.names_unit(effect, unit)) slow_by(effect.factor);
    }
  }
  if (find(numbers_.slow(unit)) != nullptr) slow_by(tables::kOrdinarySlower);
  const bool general = unit_row.general != 0;
  if (!general) set_whole(unit, time, any);
  if (any) return time;
  std::uint16_t& flags = engine_.units_[unit].flags;
  flags &= static_cast<std::uint16_t>(~kSlowed);
  if (!general && engine_.index_.types[unit_row.type].plain) flags &= static_cast<std::uint16_t>(~kGeneral);
  return time;
}

/// The place for the total time of a unit's move; null if only the ordinary malfunction slows it.
tables::Time* Malfunctions::place_of_whole(std::uint32_t unit) const noexcept {
  const auto units = slow_units_.view();
  const auto found = std::lower_bound(units.begin(), units.end(), unit);
  return found == units.end() || *found != unit ? nullptr : wholes_ + (found - units.begin());
}

void Malfunctions::set_whole(std::uint32_t unit, tables::Time time, bool slower) noexcept {
  set_bit(slowed_[unit / 64], unit, slower);
  tables::Time* const place = place_of_whole(unit);
  if (slower && place != nullptr) *place = time;
}

tables::Time Malfunctions::whole(std::uint32_t unit, tables::Time time) const noexcept {
  if ((slowed_[unit / 64] & bit_in_word(unit)) == 0) return time;
  const tables::Time* const place = place_of_whole(unit);
  return place == nullptr ? times(time, tables::kOrdinarySlower) : *place;
}

/// Equal for symbols of one address.
std::uint64_t Malfunctions::address_of(std::uint32_t symbol) const noexcept {
  const tables::SymbolRow& row = tables_.symbols[symbol];
  const bool operation = row.direction() == tables::Direction::operation;
  const std::uint32_t position = (row.type() == tables::DataType::boolean ? 0 : kSharedSlot) + row.index;
  const SharedPositions& shared = operation ? engine_.index_.shared_operations : engine_.index_.shared_events;
  const auto others = shared.empty() ? std::span<const SharedPosition>() : shared.with(position);
  return (std::uint64_t{operation} << 32) | (others.empty() ? position : others.front().leader);
}

std::uint32_t Malfunctions::of_symbol(std::uint32_t symbol) const noexcept {
  const std::uint64_t address = address_of(symbol);
  std::uint32_t found = tables::kNone;
  for (const ActiveMalfunction& a : active()) {
    numbers_.for_symbols(a.number, [&](std::uint32_t other) {
      if (address_of(other) == address) found = a.number;
    });
  }
  return found;
}

std::uint64_t Malfunctions::value_of(const tables::MalfunctionForce& force) const noexcept {
  return force.holds ? holds_[&force - tables_.malfunctions.forces.data()] : force.value;
}

/// What all active ones together do to a symbol: one after the other, as they started.
Override Malfunctions::override_of(std::uint32_t symbol) const noexcept {
  const std::uint64_t address = address_of(symbol);
  Override to{Override::Kind::none, true, 0};
  const auto give = [&](std::uint32_t other, std::uint64_t value) {
    if (address_of(other) == address) to = {Override::Kind::value, true, value};
  };
  const auto turn = [&](std::uint32_t other) {
    if (address_of(other) != address) return;
    if (to.kind == Override::Kind::value) {
      to.value ^= 1;
    } else {
      to.kind = to.kind == Override::Kind::none ? Override::Kind::opposite : Override::Kind::none;
    }
  };
  for (const ActiveMalfunction& a : active()) {
    if (!numbers_.is_written(a.number)) {
      if (!numbers_.is_of_unit(a.number)) give(numbers_.symbol(a.number), numbers_.is_on(a.number) ? 1 : 0);
      continue;
    }
    for (const tables::EffectRow& effect : active_effects(a.number)) {
      for (const tables::MalfunctionForce& force : tables_.malfunctions.forces_of(effect)) {
        give(force.symbol, value_of(force));
      }
      if (effect.kind != MalfunctionKind::flicker) continue;
      if (effects_[&effect - tables_.malfunctions.effects.data()].shows != 0) turn(effect.subject);
    }
  }
  return to;
}

/// What an event shows now, after the user's force and the malfunctions that have begun.
std::uint64_t Malfunctions::shown(std::uint32_t symbol) const noexcept {
  const tables::SymbolRow& row = tables_.symbols[symbol];
  if (row.type() != tables::DataType::boolean) return engine_.event_values_.effective(row.index);
  const std::uint32_t word = row.index / 64;
  const std::uint64_t bits = engine_.events_.current(word) ^ engine_.index_.inverted_events[word];
  return (bits & bit_in_word(row.index)) != 0 ? 1 : 0;
}

void Malfunctions::override_again(std::uint32_t symbol) noexcept {
  if (!engine_.is_forced(symbol)) engine_.override_symbol(symbol, override_of(symbol));
}

}  // namespace symplant::engine
