// Begins an instant: samples operations, queues units that are due, and steps plain units at once (the fast path).
//
// A plain unit reads only its own state and operations, and no other unit reads it. Its first step of an instant
// therefore needs no queue: depart_fast() restates step_settled() and leave(), arrive_fast() restates settle(). Each
// returns false without any effect if the unit may do more than that: then it is touched, and takes the general path.
#include <bit>

#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {

/// As switch_events_now(), for the only change of these events so far in this instant.
SYMPLANT_ALWAYS_INLINE void Engine::switch_fast(const tables::UnitRow& row, const tables::EventMasks& masks) noexcept {
  const std::uint32_t word = row.event_bit / 64;
  const std::uint32_t shift = row.event_bit % 64;
  const std::uint64_t before = events_.bits[word];
  const std::uint64_t now = (before & ~(masks.off << shift)) | (masks.on << shift);
  if (now == before) return;
  event_changes_.note_first(word, before);
  events_.bits[word] = now;
}

/// `on`: the operations of the unit that are on. If it returns true they are served.
SYMPLANT_ALWAYS_INLINE bool Engine::depart_fast(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                                std::uint64_t on) noexcept {
  UnitState& state = units_[unit];
  constexpr std::uint16_t kNotFast = kGeneral | kMoving | kHalted | kConflict | kStopped | kTouched;
  if ((state.flags & kNotFast) != 0 || (on & (on - 1)) != 0) [[unlikely]]
    return false;
  const std::uint8_t here = state.state;
  const Departure departure = type.at[here].departure(on);
  if (departure.to == here) return true;
  if (departure.to == tables::kNoState || (type.events != 0 && events_are_seen(row.event_bit / 64))) return false;
  const tables::Time now = now_;
  const tables::Time duration = times_of(row, type, departure.dt).takes;
  if (duration == 0 || duration >= tables::kNever - now) [[unlikely]]
    return false;
  state.target = static_cast<std::uint8_t>(departure.to);
  state.transition = departure.transition;
  state.flags = kMoving;
  head_->wheel.insert(units_, unit, now + duration);
  if (type.events != 0) switch_fast(row, type.at[here].leave);
  active_ = true;
  if (observer_ != nullptr) [[unlikely]]
    touched_.add(unit);
  return true;
}

/// `entry` was due and is no longer in the wheel; its flag kTimed is still set.
SYMPLANT_ALWAYS_INLINE bool Engine::arrive_fast(std::uint32_t entry) noexcept {
  UnitState& state = units_[entry];
  if (state.flags != (kMoving | kTimed)) [[unlikely]]
    return false;
  const tables::UnitRow& row = tables_.units[entry];
  const TypeIndex& type = index_.types[row.type];
  const std::uint8_t here = state.target;
  const std::uint64_t on = (operations_.bits[row.operation_bit / 64] >> (row.operation_bit % 64)) & type.operations;
  if ((on & (on - 1)) != 0 || type.at[here].departure(on).to != here) [[unlikely]]
    return false;
  if (type.events != 0) {
    if (events_are_seen(row.event_bit / 64)) [[unlikely]]
      return false;
    switch_fast(row, type.at[here].enter);
  }
  state.state = here;
  state.transition = kNoTransition;
  state.flags = 0;
  active_ = true;
  if (observer_ != nullptr) [[unlikely]]
    touched_.add(entry);
  return true;
}

/// Restates finish_operations(), for a word in which no operation may have a finding.
SYMPLANT_ALWAYS_INLINE bool Engine::close_fast(std::uint32_t word, std::uint64_t changed) noexcept {
  if (observer_ != nullptr || (changed & ~operation_words_[word].served) != 0) return false;
  finish_operations({word, changed});
  return true;
}

/// `now`: the levels of the word's operations from now on.
template <bool kFast>
SYMPLANT_ALWAYS_INLINE void Engine::change_operations(std::uint32_t word, std::uint64_t now) noexcept {
  const std::uint64_t changed = operations_.bits[word] ^ now;
  if (changed == 0) return;
  operations_.bits[word] = now;
  std::uint64_t served = operation_words_[word].served;
  const UnitOfOperation::Word unit_of = index_.unit_of_operation.of_word(word);
  for (std::uint64_t bits = changed; bits != 0;) {
    const std::uint32_t unit = unit_of[static_cast<std::uint32_t>(std::countr_zero(bits))];
    if (unit == tables::kNone) [[unlikely]] {
      bits &= bits - 1;
      continue;
    }
    const tables::UnitRow& row = tables_.units[unit];
    const TypeIndex& type = index_.types[row.type];
    const std::uint64_t of_unit = type.operations << (row.operation_bit % 64);
    bits &= ~of_unit;
    if (kFast && depart_fast(unit, row, type, (now & of_unit) >> (row.operation_bit % 64))) [[likely]] {
      served |= now & of_unit;
    } else {
      disarmed_[word] &= now;  // an operation that a round reads as off is armed
      touch(unit);
    }
  }
  operation_words_[word].served = served;
  if (!kFast || !close_fast(word, changed)) operation_changes_.add({word, changed});
  if ((index_.operation_watches.watched(word) & changed) != 0) flip_bits(index_.operation_watches, word, changed);
}

/// Samples the operations as the PLC wrote them. If an outside action happened too, apply_actions() computes the effect
/// of both.
void Engine::sample_operations(bool fast) noexcept {
  const bool acted = (head_->waits & kActed) != 0;
  for (const std::uint32_t word : written_words_.take_all()) {
    OperationWord& operation = operation_words_[word];
    operation.waiting = 0;
    const std::uint64_t level = operation.written ^ index_.inverted_operations[word];
    if (fast) [[likely]] {
      change_operations<true>(word, operations_.sample(word, level));
    } else if (!acted) {
      change_operations<false>(word, operations_.sample(word, level));
    } else {
      operations_.make(word, level);
    }
  }
  if (written_slots_.empty()) return;
  written_slots_.take_all([&](std::uint32_t slot) {
    operation_values_.made[slot] = written_values_[slot];
    acted ? operation_values_.dirty.mark(slot) : change_operation_value(slot);
  });
}

/// Applies forces and releases of operations; those of events are published as the rounds' changes are.
void Engine::apply_actions() noexcept {
  operations_.dirty.take_all([&](std::uint32_t word) { change_operations<false>(word, operations_.effective(word)); });
  operation_values_.dirty.take_all([&](std::uint32_t slot) { change_operation_value(slot); });
  head_->waits &= ~kActed;
}

/// Queues all entries that are due at `time`, which Wheel::earliest has just returned.
void Engine::queue_due(tables::Time time, bool fast) noexcept {
  const auto unit_count = static_cast<std::uint32_t>(tables_.units.size());
  for (std::uint32_t entry = head_->wheel.take(time); entry != tables::kNone;) {
    const std::uint32_t due = entry;
    entry = units_[due].next;
    if (fast && arrive_fast(due)) [[likely]]
      continue;
    units_[due].flags &= static_cast<std::uint16_t>(~kTimed);
    due < unit_count ? touch(due) : queue_other(due - unit_count);
  }
}

void Engine::queue_other(std::uint32_t entry) noexcept {
  const auto requirement_count = static_cast<std::uint32_t>(tables_.requirements.size());
  if (entry < requirement_count) {
    touched_requirements_.mark(entry);
    return;
  }
  const std::uint32_t behaviour = entry - requirement_count;
  if (behaviour >= tables_.behaviour_units.size()) {
    const std::size_t overrun = behaviour - tables_.behaviour_units.size();
    if (overrun < tables_.overruns.size()) {
      touch(tables_.overruns[overrun].unit);
    } else if (overrun - tables_.overruns.size() < flow_.wheel_entries()) {
      flow_.entry_due(static_cast<std::uint32_t>(overrun - tables_.overruns.size()));
    } else {
      values_.entry_due();
    }
    return;
  }
  behaviour_states_[behaviour].woken = 1;
  behaviour_states_[behaviour].wake = tables::kNever;
  touch(tables_.behaviour_units[behaviour].unit);
}

}  // namespace symplant::engine
