// Runs the instants between two calls.
#include <algorithm>

#include "symplant/engine/engine.hpp"
#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {

tables::Time Engine::next_due() const noexcept {
  return head_->started == 0 || head_->acted != 0 ? head_->now : head_->wheel.peek(units_);
}

/// Touches every unit, requirement and follow: the first instant, at time 0, steps all of them.
void Engine::start() noexcept {
  head_->started = 1;
  first_ = index_.some_inverted && head_->shown == 0;
  for (std::uint32_t unit = 0; unit < tables_.units.size(); ++unit) touch(unit);
  for (std::uint32_t r = 0; r < tables_.requirements.size(); ++r) touched_requirements_.mark(r);
  for (std::uint32_t f = 0; f < tables_.follows.size(); ++f) due_follows_.mark(f);
  flow_.mark_all();
}

/// Whether all steps of an instant took the fast path, and its changes need no close: run_rounds() and close_instant()
/// would have no effect.
SYMPLANT_ALWAYS_INLINE bool Engine::only_fast_steps() const noexcept {
  return observer_ == nullptr && head_->cycle == 0 && !flow_.due() &&
         (touched_.size | operation_changes_.size | operation_slot_changes_.size | touched_requirements_.list.size) ==
             0;
}

SYMPLANT_ALWAYS_INLINE void Engine::instant(tables::Time at, bool due, bool sample, Observer* observer) noexcept {
  head_->now = now_ = at;
  observer_ = observer;
  active_ = false;
  const bool fast = head_->acted == 0 && !unpublished_;
  if (sample && (!written_words_.empty() || !written_slots_.empty())) sample_operations(fast);
  if (due) queue_due(at, fast);
  if (head_->acted != 0) apply_actions();
  if (unpublished_) {
    publish();
  } else if (fast && only_fast_steps()) {
    event_changes_.next_instant();
    return;
  }
  run_rounds();
  close_instant();
}

/// Publishes what the initial states switched, and reports it, as the first instant would.
void Engine::show(Observer* observer) noexcept {
  if (head_->started != 0 || head_->shown != 0) return;
  head_->shown = 1;
  observer_ = observer;
  first_ = index_.some_inverted;
  if (unpublished_) publish();
  close_instant();
}

void Engine::advance_to(tables::Time target, Observer* observer) noexcept {
  target = std::max(target, head_->now);
  if (head_->started == 0 || head_->acted != 0) advance_before(target, observer);
  if (head_->started == 0) {
    start();
    instant(target, false, true, observer);
    return;
  }
  for (;;) {
    const tables::Time due = head_->wheel.earliest(units_, target);
    if (due < target) {
      instant(due, true, false, observer);
      continue;
    }
    const bool written = !written_words_.empty() || !written_slots_.empty() || head_->acted != 0;
    head_->now = target;
    const bool any_due = due == target && due != tables::kNever;
    if (any_due || written) instant(target, any_due, true, observer);
    return;
  }
}

void Engine::advance_before(tables::Time target, Observer* observer) noexcept {
  if (target <= head_->now) return;
  if (head_->started == 0) {
    start();
    instant(head_->now, false, false, observer);
  } else if (head_->acted != 0) {
    const bool due = head_->wheel.earliest(units_, head_->now) == head_->now;
    instant(head_->now, due, false, observer);
  }
  for (;;) {
    const tables::Time due = head_->wheel.earliest(units_, target);
    if (due >= target) break;
    instant(due, true, false, observer);
  }
  head_->now = target;
}

}  // namespace symplant::engine
