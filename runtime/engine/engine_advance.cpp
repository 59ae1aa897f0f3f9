// Runs the instants between two calls.
#include <algorithm>

#include "symplant/engine/engine.hpp"
#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {

tables::Time Engine::next_due() const noexcept {
  return head->started == 0 || head->acted != 0 ? head->now : head->wheel.peek(units);
}

void Engine::queue_other(std::uint32_t entry) noexcept {
  const auto requirement_count = static_cast<std::uint32_t>(tables.requirements.size());
  if (entry < requirement_count) {
    touched_requirements_.mark(entry);
    return;
  }
  const std::uint32_t behaviour = entry - requirement_count;
  behaviour_states[behaviour].woken = 1;
  behaviour_states[behaviour].wake = tables::kNever;
  touch(tables.behaviour_units[behaviour].unit);
}

/// Touches every unit and requirement: the first instant, at time 0, steps all of them.
void Engine::start() noexcept {
  head->started = 1;
  for (std::uint32_t unit = 0; unit < tables.units.size(); ++unit) touch(unit);
  for (std::uint32_t r = 0; r < tables.requirements.size(); ++r) touched_requirements_.mark(r);
}

/// Queues all entries that are due at `time`, which Wheel::earliest has just returned.
SYMPLANT_ALWAYS_INLINE void Engine::queue_due(tables::Time time) noexcept {
  const auto unit_count = static_cast<std::uint32_t>(tables.units.size());
  for (std::uint32_t entry = head->wheel.take(time); entry != tables::kNone; entry = units[entry].next) {
    const std::uint16_t flags = units[entry].flags;
    units[entry].flags = static_cast<std::uint16_t>(flags & ~kTimed) | (entry < unit_count ? kTouched : 0);
    if (entry < unit_count) {
      if ((flags & kTouched) == 0) touched_.add(entry);
    } else {
      queue_other(entry - unit_count);
    }
  }
}

/// As switch_events(), if no event is forced or watched: then both planes of events are equal.
SYMPLANT_ALWAYS_INLINE WordChange Engine::switch_alone(const tables::UnitRow& row,
                                                       const tables::EventMasks& masks) noexcept {
  const std::uint32_t word = row.event_bit / 64;
  if ((masks.on | masks.off) == 0) return {word, 0};  // a unit without events may lie after the plane's last word
  const std::uint64_t before = events.bits[word];
  const std::uint64_t now = (before & ~(masks.off << (row.event_bit % 64))) | masks.on << (row.event_bit % 64);
  events.bits[word] = now;
  if (now != before) {
    event_changes.note(word, before);
    event_changes.next_instant();
  }
  return {word, before ^ now};
}

/// The fast path of the most frequent instant: one plain unit arrives, and no other unit is affected. Has the effect of
/// instant(). Returns false without any effect if the instant is a different one.
SYMPLANT_ALWAYS_INLINE bool Engine::arrive_alone(tables::Time at, Observer* observer) noexcept {
  const std::uint32_t unit = head->wheel.sole(units, at);
  if (unit >= tables.units.size() || !unseen_events_ || unpublished_ || head->cycle != 0) return false;
  UnitState& state = units[unit];
  const tables::UnitRow& row = tables.units[unit];
  const TypeIndex& type = index.types[row.type];
  if (state.flags != (kMoving | kTimed) || may_leave(row, type, state.target)) return false;
  head->wheel.take(at);
  head->now = at;
  state.state = state.target;
  state.transition = kNoTransition;
  state.whole = 0;
  state.flags = 0;
  serve(state, row);
  const WordChange change = switch_alone(row, type.enter[state.state]);
  if (observer != nullptr) observer->instant({at, {&unit, 1}, {}, {&change, change.bits != 0 ? 1U : 0U}, {}, {}});
  return true;
}

SYMPLANT_ALWAYS_INLINE void Engine::instant(tables::Time at, bool sample, Observer* observer) noexcept {
  head->now = now_ = at;
  observer_ = observer;
  if (sample && (!written_words.empty() || !written_slots.empty())) sample_operations();
  if (head->acted != 0) apply_actions();
  if (unpublished_) publish();
  run_rounds();
  close_instant();
}

void Engine::advance_to(tables::Time target, Observer* observer) noexcept {
  target = std::max(target, head->now);
  if (head->started == 0 || head->acted != 0) advance_before(target, observer);
  if (head->started == 0) {
    start();
    instant(target, true, observer);
    return;
  }
  for (;;) {
    const tables::Time due = head->wheel.earliest(units, target);
    if (due < target) {
      if (arrive_alone(due, observer)) continue;
      queue_due(due);
      instant(due, false, observer);
      continue;
    }
    const bool written = !written_words.empty() || !written_slots.empty() || head->acted != 0;
    head->now = target;
    if (due == target && due != tables::kNever) {
      if (!written && arrive_alone(due, observer)) return;
      queue_due(due);
    } else if (!written) {
      return;
    }
    instant(target, true, observer);
    return;
  }
}

void Engine::advance_before(tables::Time target, Observer* observer) noexcept {
  if (target <= head->now) return;
  if (head->started == 0) {
    start();
    instant(head->now, false, observer);
  } else if (head->acted != 0) {
    if (head->wheel.earliest(units, head->now) == head->now) queue_due(head->now);
    instant(head->now, false, observer);
  }
  for (;;) {
    const tables::Time due = head->wheel.earliest(units, target);
    if (due >= target) break;
    if (arrive_alone(due, observer)) continue;
    queue_due(due);
    instant(due, false, observer);
  }
  head->now = target;
}

}  // namespace symplant::engine
