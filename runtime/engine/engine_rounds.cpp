// The rounds of an instant: one step of each touched or queued unit.
//
// A step reads only the unit's own state, its operations and published conditions, so the order of units has no effect.
#include <algorithm>
#include <bit>

#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {
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
}

/// Switches the symbols that follow a condition whose truth changed before this round. It reads only the conditions as
/// the round began, since publish() alone changes them.
void Engine::step_follows(bool counting) noexcept {
  due_follows_.take_all([&](std::uint32_t follow) {
    FollowState& state = follow_states_[follow];
    const tables::FollowRow& row = tables_.follows[follow];
    const std::uint32_t bit = tables_.symbols[row.symbol].index;
    const std::uint64_t mask = bit_in_word(bit);
    const bool on = truth(row.condition);
    if (state.frozen != 0 || on == ((events_.made(bit / 64) & mask) != 0)) return;
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
  if (found) suspects_ |= suspect(tables::FindingKind::instantaneous_loop);
  return found;
}

void Engine::run_rounds() noexcept { tables_.follows.empty() && !flow_.active() ? rounds<false>() : rounds<true>(); }

/// `kMore`: the plant has symbols that follow a condition, or material.
template <bool kMore>
SYMPLANT_ALWAYS_INLINE void Engine::rounds() noexcept {
  const auto due = [this] { return kMore && (!due_follows_.empty() || flow_.due()); };
  const auto step_others = [this](bool counting) {
    if (!due_follows_.empty()) step_follows(counting);
    if (flow_.due()) flow_.round(counting);
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
