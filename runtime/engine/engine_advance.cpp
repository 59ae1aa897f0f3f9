// Runs the instants between two calls.
#include <algorithm>

#include "symplant/engine/engine.hpp"
#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {

tables::Time Engine::next_due() const noexcept {
  const tables::Time due = head_->wheel.peek(units_);
  if (head_->waits == 0) [[likely]]
    return due;
  return (head_->waits & (kNotStarted | kActed)) != 0 ? head_->now : std::min(due, malfunctions_.next_due());
}

/// Touches every unit, requirement and follow: the first instant, at time 0, steps all of them.
void Engine::start() noexcept {
  head_->waits &= ~kNotStarted;
  first_ = index_.some_inverted && head_->shown == 0;
  for (std::uint32_t unit = 0; unit < tables_.units.size(); ++unit) touch(unit);
  for (std::uint32_t r = 0; r < tables_.requirements.size(); ++r) touched_requirements_.mark(r);
  for (std::uint32_t f = 0; f < tables_.follows.size(); ++f) due_follows_.mark(f);
  flow_.mark_all();
  malfunctions_.mark_all();
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
  const bool acted = (head_->waits & kActed) != 0;
  const bool fast = !acted && !unpublished_;
  if (sample && (!written_words_.empty() || !written_slots_.empty())) sample_operations(fast);
  if (due) queue_due(at, fast);
  if (acted) apply_actions();
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
  if ((head_->waits & kNotStarted) == 0 || head_->shown != 0) return;
  head_->shown = 1;
  observer_ = observer;
  first_ = index_.some_inverted;
  if (unpublished_) publish();
  close_instant();
}

void Engine::advance_to(tables::Time target, Observer* observer) noexcept {
  target = std::max(target, head_->now);
  if (head_->waits != 0) [[unlikely]] {
    advance_waiting(target, true, observer);
    return;
  }
  for (;;) {
    const tables::Time due = head_->wheel.earliest(units_, target);
    if (due < target) {
      instant(due, true, false, observer);
      continue;
    }
    const bool written = !written_words_.empty() || !written_slots_.empty();
    head_->now = target;
    const bool any_due = due == target && due != tables::kNever;
    if (any_due || written) instant(target, any_due, true, observer);
    return;
  }
}

void Engine::advance_before(tables::Time target, Observer* observer) noexcept {
  if (target <= head_->now) return;
  if (head_->waits != 0) [[unlikely]] {
    advance_waiting(target, false, observer);
    return;
  }
  for (;;) {
    const tables::Time due = head_->wheel.earliest(units_, target);
    if (due >= target) break;
    instant(due, true, false, observer);
  }
  head_->now = target;
}

/// As advance_to(), or as advance_before() if not `at_target`, while BlockHead::waits is not 0.
void Engine::advance_waiting(tables::Time target, bool at_target, Observer* observer) noexcept {
  for (tables::Time due = next_instant(target); due < target; due = next_instant(target)) {
    waiting_instant(due, false, observer);
  }
  head_->now = target;
  if (!at_target) return;
  const bool written = !written_words_.empty() || !written_slots_.empty();
  if (written || next_instant(target) == target) waiting_instant(target, true, observer);
  while (malfunctions_.pending()) waiting_instant(target, false, observer);
}

/// The time of the next instant up to `limit`; a later time, or kNever, if there is none.
tables::Time Engine::next_instant(tables::Time limit) noexcept {
  if ((head_->waits & (kNotStarted | kActed)) != 0 || malfunctions_.pending()) return head_->now;
  const tables::Time next = malfunctions_.next_due();
  return std::min(next, head_->wheel.earliest(units_, std::min(limit, next)));
}

/// The changes of malfunctions come before the instant, as actions from outside do.
void Engine::waiting_instant(tables::Time time, bool sample, Observer* observer) noexcept {
  if ((head_->waits & kNotStarted) != 0) start();
  head_->now = time;
  malfunctions_.begin();
  const tables::Time due = head_->wheel.earliest(units_, time);
  instant(time, due == time && due != tables::kNever, sample, observer);
}

}  // namespace symplant::engine
