// The rounds of an instant: one step of each touched or queued unit.
//
// A step reads only the unit's own state, its operations and published conditions, so the order of units has no effect.
#include <algorithm>
#include <bit>

#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {
namespace {

constexpr std::uint32_t kFirstLook = 200;  ///< rounds before the first search for loops
constexpr std::uint8_t kLoopSteps = 3;     ///< a unit with so many steps in the second half of them is in a loop

}  // namespace

/// Empties the queue without stepping its units. A behavior that called wake_at() where it may only read (see
/// Behaviour) is then woken at its unit's next step.
void Engine::forget_queue() noexcept {
  for (std::uint32_t i = 0; i < queued_; ++i) units[queue_[i]].flags &= static_cast<std::uint16_t>(~kQueued);
  queued_ = 0;
}

/// Resets the step counts. A frozen unit keeps the number of its loop there.
void Engine::forget_steps() noexcept {
  for (const std::uint32_t unit : touched_.view()) {
    if ((units[unit].flags & kFrozen) == 0) units[unit].steps = 0;
  }
}

bool Engine::look_for_loops() noexcept {
  bool found = false;
  for (const std::uint32_t unit : touched_.view()) {
    UnitState& state = units[unit];
    if ((state.flags & kFrozen) != 0 || state.steps < kLoopSteps) continue;
    if (!found && loops_ != 0xFF) ++loops_;
    found = true;
    if ((state.flags & kDisabled) == 0) halt_times(unit);
    state.flags &= static_cast<std::uint16_t>(~(kConflict | kStopped | kEnabledNow));
    state.flags |= kFrozen | kFrozenNow;
    state.steps = loops_;
  }
  if (found) suspects_ |= suspect(tables::FindingKind::instantaneous_loop);
  return found;
}

/// The fast path of leave(): the transition has a command, no record and no condition, and no other unit depends on it.
SYMPLANT_ALWAYS_INLINE void Engine::leave_plain(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                                std::uint16_t transition) noexcept {
  const tables::Time duration = tables.times[row.times + transition + std::uint32_t{1}].takes;
  if (duration == 0) {
    leave(unit, row, type, type.transitions[transition].to, transition);
    return;
  }
  UnitState& state = units[unit];
  const tables::Transition& fired = type.transitions[transition];
  served[row.operation_bit / 64] |= operation_mask(fired.on) << (row.operation_bit % 64);
  active_ = true;
  switch_events_now(row, type.leave[state.state]);
  state.target = fired.to;
  state.transition = transition;
  state.whole = duration;
  state.flags |= kMoving;
  travel(unit, state, duration);
  if (type.actuation != tables::Actuation::latched) queue(unit);
}

/// The fast path of settle(): queues the unit for another round only if it may have a cause to leave.
SYMPLANT_ALWAYS_INLINE void Engine::arrive_plain(std::uint32_t unit, const tables::UnitRow& row,
                                                 const TypeIndex& type) noexcept {
  UnitState& state = units[unit];
  const std::uint8_t here = state.target;
  state.state = here;
  state.transition = kNoTransition;
  state.whole = 0;
  state.flags &= static_cast<std::uint16_t>(~kMoving);
  active_ = true;
  switch_events_now(row, type.enter[here]);
  if (may_leave(row, type, here)) queue(unit);
}

/// The step of a settled plain unit: every transition has a command and is ready as soon as its operation is on.
SYMPLANT_ALWAYS_INLINE void Engine::step_plain(std::uint32_t unit, const tables::UnitRow& row,
                                               const TypeIndex& type) noexcept {
  const std::uint8_t here = units[unit].state;
  const std::uint64_t on = operations_on(row, type);
  const std::uint64_t ready = on & type.starts[here];
  const bool stay_wanted = (on & type.leads[here] & ~ready) != 0;
  if (ready == 0) {
    if (type.actuation == tables::Actuation::spring && here != type.rest && !stay_wanted) {
      leave(unit, row, type, type.rest, kNoTransition);
    }
    return;
  }
  if (type.only_transition[here] != kNoRecord && !stay_wanted) {
    leave_plain(unit, row, type, type.only_transition[here]);
    return;
  }
  std::uint16_t first = kNoTransition;
  bool conflict = stay_wanted;
  for (const std::uint16_t n : type.from(here)) {
    if ((ready & operation_mask(type.transitions[n].on)) == 0) continue;
    if (first == kNoTransition) {
      first = n;
    } else if (type.transitions[n].to != type.transitions[first].to) {
      conflict = true;
    }
  }
  if (conflict) {
    found_conflict(unit);
  } else {
    leave_plain(unit, row, type, first);
  }
}

SYMPLANT_ALWAYS_INLINE void Engine::step(std::uint32_t unit) noexcept {
  UnitState& state = units[unit];
  const tables::UnitRow& row = tables.units[unit];
  const TypeIndex& type = index.types[row.type];
  constexpr std::uint16_t kUnusual = kGeneral | kHalted | kMidway | kConflict | kStopped;
  if ((state.flags & kUnusual) != 0) {
    step_any(unit, row, type);
  } else if ((state.flags & kMoving) == 0) {
    step_plain(unit, row, type);
  } else if (state.due <= now_) {
    clear_wheel(unit);
    arrive_plain(unit, row, type);
  } else if (type.actuation != tables::Actuation::latched) {
    step_moving(unit, row, type);
  }
}

/// Steps all touched units.
SYMPLANT_ALWAYS_INLINE void Engine::first_round() noexcept {
  const std::uint32_t count = touched_.size;
  for (std::uint32_t i = 0; i < count; ++i) step(touched_.items[i]);
}

/// Steps the first `count` units of the queue, and with `counting` counts their steps. A unit that needs another round
/// is queued at the front, in slots that have been read already.
void Engine::further_round(std::uint32_t count, bool counting) noexcept {
  bool any = false;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t unit = queue_[i];
    units[unit].flags &= static_cast<std::uint16_t>(~kQueued);
    active_ = false;
    step(unit);
    if (counting && active_ && units[unit].steps < kLoopSteps) ++units[unit].steps;
    any = any || active_;
  }
  active_ = any;
}

void Engine::run_rounds() noexcept {
  if (touched_.size == 0) return;
  std::uint32_t limit = kFirstLook;
  round_ = 1;
  active_ = false;
  first_round();
  if (unpublished_) publish();
  while (queued_ != 0 && active_) {
    const std::uint32_t count = queued_;
    queued_ = 0;
    active_ = false;
    ++round_;
    if (round_ == limit / 2 + 1) forget_steps();
    further_round(count, round_ > limit / 2);
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
