// Publishes the changes of an instant's start or of one round: images after forces, conditions, disabled units.
#include <algorithm>
#include <bit>
#include <utility>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/tables/compare.hpp"

namespace symplant::engine {

void Engine::flip(std::uint32_t condition, std::uint8_t input) noexcept {
  std::uint8_t& state = condition_states_[condition];
  state ^= static_cast<std::uint8_t>(1U << input);
  if ((state & kWaiting) != 0) return;
  state |= kWaiting;
  waiting_.add(condition);
  unpublished_ = true;
}

/// Publishes the state of a unit that stepped to conditions and to the units that it disables.
SYMPLANT_ALWAYS_INLINE void Engine::publish_unit(std::uint32_t unit) noexcept {
  UnitState& state = units_[unit];
  state.flags &= static_cast<std::uint16_t>(~kDriven);
  const std::uint32_t position = index_.general.position_of(unit);
  const GeneralRow& general = index_.general.rows()[position];
  const std::uint8_t now = (state.flags & kMoving) != 0 ? tables::kMovingState : state.state;
  const std::uint8_t before = std::exchange(general_states_[position].position, now);
  if (now == before) return;
  for (std::uint32_t w = general.watch_begin; w < general.watch_end; ++w) {
    const tables::UnitWatch& watch = tables_.unit_watches[w];
    if (watch.state == now || watch.state == before) flip(watch.condition, watch.input);
  }
  for (std::uint32_t d = general.disable_begin; d < general.disable_end; ++d) {
    const tables::DisableRow& disable = tables_.disables[d];
    if (disable.state != now && disable.state != before) continue;
    const std::uint32_t other = index_.general.position_of(disable.unit);
    general_states_[other].disabled_by += disable.state == now ? 1U : ~0U;
    if (general_states_[other].counted != 0) continue;
    general_states_[other].counted = 1;
    counted_.add(other);
  }
}

void Engine::change_operation_value(std::uint32_t slot) noexcept {
  const std::uint64_t now = operation_values_.effective(slot);
  if (operation_values_.values[slot] == now) return;
  operation_values_.values[slot] = now;
  operation_slot_changes_.add(slot);
  compare_value(tables_.operation_value_watches, slot, now);
  if (flow_.active()) flow_.value_changed(tables::Direction::operation, slot);
  if (values_.active()) values_.value_changed(tables::Direction::operation, slot, now);
  touch_readers(tables::Direction::operation, slot);
}

void Engine::publish() noexcept {
  unpublished_ = false;
  events_.dirty.take_all([&](std::uint32_t word) { publish_event_word(word); });
  if (!event_values_.dirty.empty()) publish_values();
  if (flow_.active()) flow_.publish_counters();
  if (moved_.size != 0) {
    for (const std::uint32_t unit : moved_.view()) publish_unit(unit);
    moved_.size = 0;
  }
  if (values_.active()) values_.publish();
  if (waiting_.size != 0) settle_conditions();
  if (counted_.size != 0) settle_disables();
}

void Engine::publish_event_word(std::uint32_t word) noexcept {
  const std::uint64_t now = events_.effective(word);
  const std::uint64_t changed = events_.bits[word] ^ now;
  if (changed == 0) return;
  event_changes_.note(word, events_.bits[word]);
  events_.bits[word] = now;
  if ((index_.event_watches.watched(word) & changed) != 0) flip_bits(index_.event_watches, word, changed);
}

void Engine::publish_values() noexcept {
  event_values_.dirty.take_all([&](std::uint32_t slot) {
    const std::uint64_t now = event_values_.effective(slot);
    if (event_values_.values[slot] == now) return;
    if (touched_slots_.mark(slot)) values_before_[slot] = event_values_.values[slot];
    event_values_.values[slot] = now;
    compare_value(tables_.event_value_watches, slot, now);
    if (flow_.active()) flow_.value_changed(tables::Direction::event, slot);
    if (values_.active()) values_.value_changed(tables::Direction::event, slot, now);
  });
}

void Engine::flip_bits(const WatchIndex& watches, std::uint32_t word, std::uint64_t bits) noexcept {
  for (bits &= watches.watched(word); bits != 0; bits &= bits - 1) {
    const std::uint32_t bit = word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
    for (const tables::BitWatch& watch : watches.on(bit)) flip(watch.condition, watch.input);
  }
}

void Engine::compare_value(std::span<const tables::ValueWatch> watches, std::uint32_t slot,
                           std::uint64_t value) noexcept {
  auto watch = std::lower_bound(watches.begin(), watches.end(), slot,
                                [](const tables::ValueWatch& a, std::uint32_t b) { return a.slot < b; });
  for (; watch != watches.end() && watch->slot == slot; ++watch) {
    const bool was = (condition_states_[watch->condition] >> watch->input & 1) != 0;
    if (was != tables::holds(*watch, value)) flip(watch->condition, watch->input);
  }
}

/// Whether a unit steps if one of its conditions changes. A unit in a move that nothing stops reads its conditions when
/// it arrives.
bool Engine::looks_at_conditions(std::uint32_t unit) const noexcept {
  const std::uint16_t flags = units_[unit].flags;
  if ((flags & (kMoving | kBehaves)) != kMoving) return (flags & kHalted) == 0;
  const TypeIndex& type = index_.types[tables_.units[unit].type];
  return type.actuation != tables::Actuation::latched || type.stoppable;
}

void Engine::settle_conditions() noexcept {
  while (waiting_.size != 0) {
    const std::uint32_t condition = waiting_.items[--waiting_.size];
    std::uint8_t& state = condition_states_[condition];
    state &= static_cast<std::uint8_t>(~kWaiting);
    const tables::ConditionRow& row = tables_.conditions[condition];
    const bool now = (row.truth >> (state & kInputs) & 1) != 0;
    if (now == ((state & kTruth) != 0)) continue;
    state ^= kTruth;
    switch (row.reader_kind) {
      case tables::ReaderKind::unit:
        if (looks_at_conditions(row.reader)) queue(row.reader);
        break;
      case tables::ReaderKind::condition:
        flip(row.reader, row.reader_input);
        break;
      case tables::ReaderKind::requirement:
        touched_requirements_.mark(row.reader);
        break;
      case tables::ReaderKind::follow:
        due_follows_.mark(row.reader);
        break;
      case tables::ReaderKind::malfunction:
        malfunctions_.condition_changed(row.reader);
        break;
      case tables::ReaderKind::change:
      case tables::ReaderKind::formula_input:
        values_.condition_changed(row.reader_kind, row.reader, now);
        break;
      default:
        flow_.condition_changed(row.reader_kind, row.reader);
        break;
    }
  }
}

void Engine::settle_disables() noexcept {
  for (const std::uint32_t position : counted_.view()) {
    general_states_[position].counted = 0;
    const std::uint32_t unit = index_.general.rows()[position].unit;
    UnitState& state = units_[unit];
    const bool disable = general_states_[position].disabled_by != 0;
    if (disable == ((state.flags & kDisabled) != 0)) continue;
    active_ = true;
    touch(unit);
    if (disable) {
      this->disable(unit);
    } else if (enable(unit, kEnabledNow)) {
      suspects_ |= suspect(tables::FindingKind::started_on_enabling);
      queue(unit);
    }
  }
  counted_.size = 0;
}

}  // namespace symplant::engine
