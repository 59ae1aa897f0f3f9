// Runs the instants between two calls, each in rounds.
#include <algorithm>
#include <bit>

#include "symplant/engine/engine.hpp"
#include "symplant/engine/engine_inline.hpp"

//
// A step reads only the unit's own state, its operations and published conditions, so the order of units has no effect.

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
  values_.mark_all();
}

/// Whether all steps of an instant took the fast path, and its changes need no close: run_rounds() and close_instant()
/// would have no effect.
SYMPLANT_ALWAYS_INLINE bool Engine::only_fast_steps() const noexcept {
  return observer_ == nullptr && head_->cycle == 0 && !flow_.due() && !values_.due() &&
         (touched_.size | operation_changes_.size | operation_slot_changes_.size | touched_requirements_.list.size) ==
             0;
}

SYMPLANT_ALWAYS_INLINE void Engine::instant(tables::Time at, bool due, bool sample, Observer* observer) noexcept {
  head_->now = now_ = at;
  observer_ = observer;
  active_ = false;
  if (values_.active()) values_.begin_instant();
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
  if (values_.due()) {
    values_.compute();
    if (unpublished_) publish();
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
    if (values_.active()) values_.end_time();
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
  if (values_.active()) values_.end_time();
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

namespace {

constexpr std::uint32_t kFirstLook = 200;  ///< rounds before the first search for loops

}  // namespace

/// Empties the queue without stepping its units. A behavior that called wake_at() where it may only read (see
/// Behaviour) is then woken at its unit's next step.
void Engine::forget_queue() noexcept {
  for (std::uint32_t i = 0; i < queued_; ++i) units_[queue_[i]].flags &= static_cast<std::uint16_t>(~kQueued);
  queued_ = 0;
}

/// Resets the step counts. A unit that was frozen in this instant keeps the number of its loop there.
void Engine::forget_steps() noexcept {
  for (const std::uint32_t unit : touched_.view()) {
    if ((units_[unit].flags & kFrozen) == 0) units_[unit].steps = 0;
  }
  for (std::size_t f = 0; f < tables_.follows.size(); ++f) {
    if (follow_states_[f].frozen == 0) follow_states_[f].steps = 0;
  }
  if (flow_.active()) flow_.forget_steps();
  if (values_.active()) values_.forget_steps();
}

/// Switches the symbols that follow a condition whose truth changed before this round. It reads only the conditions as
/// the round began, since publish() alone changes them.
void Engine::step_follows(bool counting) noexcept {
  due_follows_.take_all([&](std::uint32_t follow) {
    FollowState& state = follow_states_[follow];
    const tables::FollowRow& row = tables_.follows[follow];
    const std::uint32_t bit = tables_.symbols[row.symbol].index;
    const std::uint64_t mask = bit_in_word(bit);
    const bool was = (events_.made(bit / 64) & mask) != 0;
    const bool stays = row.off != tables::kNone && was;
    const bool on = (truth(row.condition) || stays) && (row.off == tables::kNone || !truth(row.off));
    if (state.frozen != 0 || on == was) return;
    make_event_bits(bit / 64, on ? mask : 0, on ? 0 : mask);
    active_ = true;
    if (counting && state.steps < kLoopSteps) ++state.steps;
  });
}

bool Engine::look_for_loops() noexcept {
  bool found = false;
  for (const std::uint32_t unit : touched_.view()) {
    UnitState& state = units_[unit];
    if ((state.flags & kFrozen) != 0 || state.steps < kLoopSteps) continue;
    if (!found && loops_ != 0xFF) ++loops_;
    found = true;
    if ((state.flags & kDisabled) == 0) halt_times(unit);
    state.flags &= static_cast<std::uint16_t>(~(kConflict | kStopped | kEnabledNow));
    state.flags |= kFrozen;
    state.steps = loops_;
  }
  for (std::size_t f = 0; f < tables_.follows.size(); ++f) {
    FollowState& state = follow_states_[f];
    if (state.frozen != 0 || state.steps < kLoopSteps) continue;
    if (!found && loops_ != 0xFF) ++loops_;
    found = true;
    state = {kFrozenInThisInstant, loops_};
  }
  if (flow_.active() && flow_.has_loop()) {
    if (!found && loops_ != 0xFF) ++loops_;
    found = true;
    flow_.freeze_loop(loops_);
  }
  if (values_.active() && values_.has_loop()) {
    if (!found && loops_ != 0xFF) ++loops_;
    found = true;
    values_.freeze_loop(loops_);
  }
  if (found) suspects_ |= suspect(tables::FindingKind::instantaneous_loop);
  return found;
}

void Engine::run_rounds() noexcept {
  tables_.follows.empty() && !flow_.active() && !values_.active() ? rounds<false>() : rounds<true>();
}

/// `kMore`: the plant has symbols that follow a condition, material, or values.
template <bool kMore>
SYMPLANT_ALWAYS_INLINE void Engine::rounds() noexcept {
  const auto due = [this] { return kMore && (!due_follows_.empty() || flow_.due() || values_.jumps_due()); };
  const auto step_others = [this](bool counting) {
    if (!due_follows_.empty()) step_follows(counting);
    if (flow_.due()) flow_.round(counting);
    if (values_.jumps_due()) values_.round(counting);
  };
  if (kMore && flow_.active()) flow_.begin_rounds();
  if (touched_.size == 0 && !due()) return;
  std::uint32_t limit = kFirstLook;
  round_ = 1;
  step_all(touched_.items, touched_.size, false);
  if (due()) step_others(false);
  if (unpublished_) publish();
  while ((queued_ != 0 || due()) && active_) {
    const std::uint32_t count = queued_;
    queued_ = 0;
    active_ = false;
    ++round_;
    if (round_ == limit / 2 + 1) forget_steps();
    step_all(queue_, count, round_ > limit / 2);
    if (due()) step_others(round_ > limit / 2);
    if (unpublished_) publish();
    if (round_ != limit || !active_) continue;
    const bool found = look_for_loops();
    round_ = found ? 0 : round_;
    limit = found ? kFirstLook : 2 * limit;
  }
  if (queued_ != 0) forget_queue();
  if (limit != kFirstLook || round_ > limit / 2 || loops_ != 0) forget_steps();
  round_ = 0;
}

}  // namespace symplant::engine
