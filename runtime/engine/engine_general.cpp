// The general path: the step of a unit with any features, and firing and arriving.
#include <algorithm>

#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {

/// Whether a cause has held for its transition's `after`. If not yet, lowers `earliest` to the time at which it will
/// have.
SYMPLANT_ALWAYS_INLINE bool Engine::holds_long_enough(std::uint32_t unit, const tables::UnitRow& row,
                                                      std::uint16_t transition, bool cause, Record& record,
                                                      tables::Time& earliest) noexcept {
  if (!cause) {
    record.holds = 0;
    return false;
  }
  units_[unit].holding = 1;
  if (record.holds == 0) {
    record.holds = 1;
    record.ready = later(head_->now, after(unit, row, transition));
  }
  if (record.ready <= head_->now) return true;
  earliest = std::min(earliest, record.ready);
  return false;
}

/// Evaluates every transition from the state, also those after one that will fire: a cause that begins to hold draws
/// its random `after`.
SYMPLANT_ALWAYS_INLINE Engine::Ready Engine::ready_transitions(std::uint32_t unit, const tables::UnitRow& row,
                                                               const TypeIndex& type, std::uint64_t on) noexcept {
  Ready ready{kNoTransition, kNoTransition, false, 0};
  tables::Time earliest = tables::kNever;
  const bool general = row.general != 0;
  const std::uint32_t first_condition = general ? general_row(unit).first_condition : 0;
  const std::uint32_t first_record = general ? general_row(unit).first_record : 0;
  UnitState& state = units_[unit];
  state.holding = 0;
  for (const std::uint16_t n : type.from(state.state)) {
    const tables::Transition& transition = type.transitions[n];
    if (transition.on == tables::kSpringReturn) continue;
    const bool automatic = transition.on == tables::kNoOperation;
    const bool cause = (automatic || (on & operation_mask(transition.on)) != 0) &&
                       (transition.when == tables::kNoCondition || truth(first_condition + transition.when));
    if (type.record_of[n] != kNoRecord) {
      Record& record = records_[first_record + type.record_of[n]];
      if (!holds_long_enough(unit, row, n, cause, record, earliest)) continue;
    }
    if (!cause) continue;
    if (automatic) {
      if (ready.automatic == kNoTransition) ready.automatic = n;
      continue;
    }
    ready.served |= operation_mask(transition.on);
    if (ready.first == kNoTransition) {
      ready.first = n;
    } else if (type.transitions[ready.first].to != transition.to) {
      ready.several = true;
    }
  }
  if ((state.flags & kTimed) == 0 ? earliest != tables::kNever : earliest != state.due) set_wheel(unit, earliest);
  return ready;
}

void Engine::found_conflict(std::uint32_t unit) noexcept {
  units_[unit].flags |= kConflict;
  suspects_ |= suspect(tables::FindingKind::conflicting_operations);
}

void Engine::settle(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type) noexcept {
  UnitState& state = units_[unit];
  const std::uint8_t here = state.target;
  state.state = here;
  state.transition = kNoTransition;
  state.whole = 0;
  state.flags &= static_cast<std::uint16_t>(~(kMoving | kMidway));
  stepped(unit, row);
  const bool further = behaves(unit);
  if (further) {  // the behavior may switch the same events again
    switch_events(row, type.at[here].enter);
    report_entered(unit, here);
  } else {
    switch_events_now(row, type.at[here].enter);
  }
  if (further || type.at[here].automatic || may_leave(row, type, here)) queue(unit);
}

/// Fires a transition: serves and disarms operations, then begins the move, or settles at once if it takes no time.
void Engine::leave(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type, std::uint8_t target,
                   std::uint16_t transition) noexcept {
  UnitState& state = units_[unit];
  const std::uint8_t here = state.state;
  const tables::Time duration = takes(unit, row, type, target, transition);
  bool automatic = false;
  if (transition != kNoTransition) {
    const tables::Transition& fired = type.transitions[transition];
    const std::uint32_t word = row.operation_bit / 64;
    automatic = fired.on == tables::kNoOperation;
    if (!automatic) {
      const std::uint64_t on = operation_mask(fired.on) << (row.operation_bit % 64);
      operation_words_[word].served |= on;
      if (fired.once && type.actuation == tables::Actuation::latched) disarmed_[word] |= on;
    } else if (type.actuation == tables::Actuation::latched && type.operations != 0) {
      disarmed_[word] |= (type.at[here].leads << (row.operation_bit % 64)) & operations_.bits[word];
    }
  }
  clear_wheel(unit);
  if (state.holding != 0) forget_causes(unit, type, here);
  stepped(unit, row);
  state.target = target;
  state.transition = transition;
  state.whole = duration;
  state.flags |= kMoving;
  if (duration == 0 || behaves(unit)) {
    switch_events(row, type.at[here].leave);
    if (behaves(unit)) report_left(unit, here);
    if (duration == 0) {
      settle(unit, row, type);
      return;
    }
  } else {
    switch_events_now(row, type.at[here].leave);
  }
  travel(unit, state, duration);
  // A command back would have kept the unit in its state, so that only a behavior can act on the move in this instant.
  if (!automatic && type.actuation != tables::Actuation::latched && behaves(unit)) queue(unit);
}

SYMPLANT_ALWAYS_INLINE void Engine::step_settled(std::uint32_t unit, const tables::UnitRow& row,
                                                 const TypeIndex& type) noexcept {
  const std::uint8_t here = units_[unit].state;
  const std::uint64_t on = operations_on(row, type);
  Ready ready{kNoTransition, kNoTransition, false, 0};
  if ((on & type.at[here].starts) != 0 || type.at[here].automatic || units_[unit].holding != 0) {
    ready = ready_transitions(unit, row, type, on);
  }
  if (ready.automatic != kNoTransition) {
    leave(unit, row, type, type.transitions[ready.automatic].to, ready.automatic);
    return;
  }
  const std::uint8_t further = behaves(unit) ? wanted_by_behaviour(unit) : tables::kNoState;
  const bool stay_wanted = (on & type.at[here].leads & ~ready.served) != 0 || further == here;
  std::uint8_t wanted = ready.first == kNoTransition ? tables::kNoState : type.transitions[ready.first].to;
  bool conflict = ready.several;
  if (further != tables::kNoState && further != here) {
    conflict = conflict || (wanted != tables::kNoState && wanted != further);
    wanted = further;
  }
  if (wanted != tables::kNoState) {
    if (conflict || stay_wanted) {
      found_conflict(unit);
    } else {
      leave(unit, row, type, wanted, ready.first);
    }
  } else if (!stay_wanted && type.actuation == tables::Actuation::spring && here != type.rest) {
    leave(unit, row, type, type.rest, kNoTransition);
  }
}

void Engine::step(std::uint32_t unit) noexcept {
  UnitState& state = units_[unit];
  const tables::UnitRow& row = tables_.units[unit];
  const TypeIndex& type = index_.types[row.type];
  if ((state.flags & kHalted) != 0) return;
  state.flags &= static_cast<std::uint16_t>(~(kConflict | kStopped));
  if (behaves(unit)) wake_behaviour(unit, row);
  if ((state.flags & kMoving) == 0) {
    step_settled(unit, row, type);
  } else if ((state.flags & kMidway) == 0 && state.due <= head_->now) {
    clear_wheel(unit);
    settle(unit, row, type);
  } else {
    step_moving(unit, row, type);
  }
}

}  // namespace symplant::engine
