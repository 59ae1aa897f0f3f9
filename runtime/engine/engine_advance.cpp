// Runs the instants between two calls.
#include <algorithm>

#include "symplant/engine/engine.hpp"
#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {

tables::Time Engine::next_due() const noexcept {
  return head->started == 0 || head->acted != 0 ? head->now : head->wheel.peek(units);
}

/// Touches every unit and requirement: the first instant, at time 0, steps all of them.
void Engine::start() noexcept {
  head->started = 1;
  for (std::uint32_t unit = 0; unit < tables.units.size(); ++unit) touch(unit);
  for (std::uint32_t r = 0; r < tables.requirements.size(); ++r) touched_requirements_.mark(r);
}

/// Whether all steps of an instant took the fast path, and its changes need no close: run_rounds() and close_instant()
/// would have no effect.
SYMPLANT_ALWAYS_INLINE bool Engine::only_fast_steps() const noexcept {
  return observer_ == nullptr && head->cycle == 0 &&
         (touched_.size | operation_changes_.size | operation_slot_changes_.size | touched_requirements_.list.size) ==
             0;
}

SYMPLANT_ALWAYS_INLINE void Engine::instant(tables::Time at, bool due, bool sample, Observer* observer) noexcept {
  head->now = now_ = at;
  observer_ = observer;
  active_ = false;
  const bool fast = head->acted == 0 && !unpublished_;
  if (sample && (!written_words.empty() || !written_slots.empty())) sample_operations(fast);
  if (due) queue_due(at, fast);
  if (head->acted != 0) apply_actions();
  if (unpublished_) {
    publish();
  } else if (fast && only_fast_steps()) {
    event_changes.next_instant();
    return;
  }
  run_rounds();
  close_instant();
}

void Engine::advance_to(tables::Time target, Observer* observer) noexcept {
  target = std::max(target, head->now);
  if (head->started == 0 || head->acted != 0) advance_before(target, observer);
  if (head->started == 0) {
    start();
    instant(target, false, true, observer);
    return;
  }
  for (;;) {
    const tables::Time due = head->wheel.earliest(units, target);
    if (due < target) {
      instant(due, true, false, observer);
      continue;
    }
    const bool written = !written_words.empty() || !written_slots.empty() || head->acted != 0;
    head->now = target;
    const bool any_due = due == target && due != tables::kNever;
    if (any_due || written) instant(target, any_due, true, observer);
    return;
  }
}

void Engine::advance_before(tables::Time target, Observer* observer) noexcept {
  if (target <= head->now) return;
  if (head->started == 0) {
    start();
    instant(head->now, false, false, observer);
  } else if (head->acted != 0) {
    const bool due = head->wheel.earliest(units, head->now) == head->now;
    instant(head->now, due, false, observer);
  }
  for (;;) {
    const tables::Time due = head->wheel.earliest(units, target);
    if (due >= target) break;
    instant(due, true, false, observer);
  }
  head->now = target;
}

}  // namespace symplant::engine
