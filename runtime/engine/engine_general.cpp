// The general path: the step of a unit with any features, its moves and its times.
#include <algorithm>
#include <utility>

#include "symplant/engine/draw.hpp"
#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/wide.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::engine {
/// The ready transitions of a settled unit in a round.
struct Engine::Ready {
  std::uint16_t automatic;  ///< the first automatic one, or kNoTransition
  std::uint16_t first;      ///< the first commanded one, or kNoTransition
  bool several;             ///< the commanded ones lead to different states
  std::uint64_t served;     ///< the operations that command them
};

/// Whether a cause that holds has held for its transition's `after`. `held`: the unit's records are valid.
SYMPLANT_ALWAYS_INLINE bool Engine::holds_long_enough(std::uint32_t unit, const tables::UnitRow& row,
                                                      const TypeIndex& type, std::uint16_t transition, bool held,
                                                      Record& record) noexcept {
  if (!held || record.holds == 0) {
    record.holds = 1;
    record.ready = later(now_, after(unit, row, type, transition));
  }
  return record.ready <= now_;
}

/// Evaluates every transition from the state, also those after one that will fire: a cause that begins to hold draws
/// its random `after`.
SYMPLANT_ALWAYS_INLINE Engine::Ready Engine::ready_transitions(std::uint32_t unit, const tables::UnitRow& row,
                                                               const TypeIndex& type, std::uint64_t on) noexcept {
  Ready ready{kNoTransition, kNoTransition, false, 0};
  tables::Time earliest = tables::kNever;
  const GeneralRow* const general = row.general != 0 ? &general_row(unit) : nullptr;
  UnitState& state = units_[unit];
  const bool held = state.holding != 0;
  bool holding = false;
  for (const std::uint16_t n : type.from(state.state)) {
    const tables::Transition& transition = type.transitions[n];
    if (transition.on == tables::kSpringReturn) continue;
    const bool automatic = transition.on == tables::kNoOperation;
    const bool cause = (automatic || (on & operation_mask(transition.on)) != 0) &&
                       (transition.when == tables::kNoCondition || truth(general->first_condition + transition.when));
    if (type.record_of[n] != kNoRecord) {
      Record& record = records_[general->first_record + type.record_of[n]];
      if (!cause) {
        record.holds = 0;
        continue;
      }
      holding = true;
      if (!holds_long_enough(unit, row, type, n, held, record)) {
        earliest = std::min(earliest, record.ready);
        continue;
      }
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
  state.holding = holding ? 1 : 0;
  if ((state.flags & kTimed) == 0 ? earliest != tables::kNever : earliest != state.due) set_wheel(unit, earliest);
  return ready;
}

/// One of the ready automatic transitions that have a weight, of which `first` is the first one. Each has a record.
std::uint16_t Engine::drawn_by_weight(std::uint32_t unit, const TypeIndex& type, std::uint16_t first) noexcept {
  Record* const records = records_ + general_row(unit).first_record;
  const auto weight_of = [&](std::uint16_t n) -> std::uint32_t {
    const std::uint32_t weight = type.transitions[n].numbers.weight;
    if (weight == 0) return 0;
    const Record& record = records[type.record_of[n]];
    return record.holds != 0 && record.ready <= now_ ? weight : 0;
  };
  std::uint64_t weights = 0;
  for (const std::uint16_t n : type.from(units_[unit].state)) weights += weight_of(n);
  std::uint64_t random = draw_start(head_->seed, name_hash(unit), first, records[type.record_of[first]].draws++);
  auto share = static_cast<std::uint64_t>(static_cast<Wide>(split_mix(random)) * weights >> 64);
  for (const std::uint16_t n : type.from(units_[unit].state)) {
    const std::uint32_t weight = weight_of(n);
    if (share < weight) return n;
    share -= weight;
  }
  return first;
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
  state.holding = 0;
  stepped(unit, row);
  state.target = target;
  state.transition = transition;
  if (row.general != 0) general_state(unit).whole = duration;
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
  if (type.stoppable && must_stop(unit, type)) queue(unit);
  // A command back would have kept the unit in its state, so that only a behavior can act on the move in this instant.
  if (!automatic && type.actuation != tables::Actuation::latched && behaves(unit)) queue(unit);
}

/// The state for which a settled unit leaves by a command or by a spring's return, or kNoState.
SYMPLANT_ALWAYS_INLINE std::uint8_t Engine::destination(std::uint32_t unit, const TypeIndex& type, std::uint64_t on,
                                                        const Ready& ready) noexcept {
  const std::uint8_t here = units_[unit].state;
  const std::uint8_t further = behaves(unit) ? wanted_by_behaviour(unit) : tables::kNoState;
  if (ready.first == kNoTransition && further == tables::kNoState) {
    const bool returns = type.actuation == tables::Actuation::spring && (on & type.at[here].leads) == 0;
    return returns && here != type.rest ? type.rest : tables::kNoState;
  }
  const bool stay_wanted = (on & type.at[here].leads & ~ready.served) != 0 || further == here;
  std::uint8_t wanted = ready.first == kNoTransition ? tables::kNoState : type.transitions[ready.first].to;
  bool conflict = ready.several;
  if (further != tables::kNoState && further != here) {
    conflict = conflict || (wanted != tables::kNoState && wanted != further);
    wanted = further;
  }
  if (wanted != tables::kNoState && (conflict || stay_wanted)) {
    found_conflict(unit);
    return tables::kNoState;
  }
  return wanted;
}

SYMPLANT_ALWAYS_INLINE void Engine::step_settled(std::uint32_t unit, const tables::UnitRow& row,
                                                 const TypeIndex& type) noexcept {
  const StateIndex& at = type.at[units_[unit].state];
  const std::uint64_t on = operations_on(row, type);
  Ready ready{kNoTransition, kNoTransition, false, 0};
  if ((on & at.starts) != 0 || at.automatic || units_[unit].holding != 0)
    ready = ready_transitions(unit, row, type, on);
  std::uint16_t transition = ready.first;
  std::uint8_t target = tables::kNoState;
  if (ready.automatic != kNoTransition) {
    transition = type.transitions[ready.automatic].numbers.weight == 0 ? ready.automatic
                                                                       : drawn_by_weight(unit, type, ready.automatic);
    target = type.transitions[transition].to;
  } else {
    target = destination(unit, type, on, ready);
  }
  if (target != tables::kNoState) leave(unit, row, type, target, transition);
}

SYMPLANT_ALWAYS_INLINE void Engine::step(std::uint32_t unit) noexcept {
  UnitState& state = units_[unit];
  const tables::UnitRow& row = tables_.units[unit];
  const TypeIndex& type = index_.types[row.type];
  if ((state.flags & kHalted) != 0) return;
  state.flags &= static_cast<std::uint16_t>(~(kConflict | kStopped));
  if (behaves(unit)) wake_behaviour(unit, row);
  if ((state.flags & kMoving) == 0) {
    step_settled(unit, row, type);
  } else if ((state.flags & kMidway) == 0 && state.due <= now_) {
    clear_wheel(unit);
    settle(unit, row, type);
  } else {
    step_moving(unit, row, type);
  }
}

/// Steps units of this round, with `counting` counts their steps, and sets active_ if one steps. A unit that needs
/// another round is queued; `units` may be the queue: its front has been read already.
void Engine::step_all(const std::uint32_t* units, std::uint32_t count, bool counting) noexcept {
  bool any = active_;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t unit = units[i];
    if ((units_[unit].flags & kTouched) == 0) [[unlikely]]  // took the fast path
      continue;
    units_[unit].flags &= static_cast<std::uint16_t>(~kQueued);
    active_ = false;
    step(unit);
    if (counting && active_ && units_[unit].steps < kLoopSteps) ++units_[unit].steps;
    any = any || active_;
  }
  active_ = any;
}

namespace {

/// The remaining time of a move that reverses: floor(back * travelled / forth).
tables::Time time_back(tables::Time back, tables::Time travelled, tables::Time forth) noexcept {
  if (forth == 0) return 0;
  return static_cast<tables::Time>(static_cast<Wide>(back) * static_cast<Wide>(travelled) / static_cast<Wide>(forth));
}

}  // namespace

/// What the operations of a moving unit command.
struct Engine::Wishes {
  bool forth;                       ///< to continue to the target
  bool back;                        ///< to reverse
  std::uint16_t return_transition;  ///< the transition that commands `back`, or kNoTransition
};

Engine::Wishes Engine::wishes_of(std::uint32_t unit, const TypeIndex& type, std::uint64_t on) noexcept {
  const UnitState& state = units_[unit];
  std::uint64_t forth = 0;  // operations that command the current move
  for (const std::uint16_t n : type.from(state.state)) {
    const tables::Transition& transition = type.transitions[n];
    if (transition.to == state.target && transition.on < tables::kMaxOperations) forth |= operation_mask(transition.on);
  }
  Wishes wishes{(on & forth) != 0, false, kNoTransition};
  for (const std::uint16_t n : type.from(state.target)) {
    const tables::Transition& transition = type.transitions[n];
    if (transition.to != state.state || transition.on >= tables::kMaxOperations) continue;
    if ((on & ~forth & operation_mask(transition.on)) == 0) continue;
    if (transition.when != tables::kNoCondition && !truth(general_row(unit).first_condition + transition.when))
      continue;
    wishes.back = true;
    wishes.return_transition = n;
    break;
  }
  if (behaves(unit)) {
    const std::uint8_t further = wanted_by_behaviour(unit);
    wishes.forth = wishes.forth || further == state.target;
    wishes.back = wishes.back || further == state.state;
  }
  return wishes;
}

/// Whether the `during` of a moving unit's transition does not hold. Only of a stoppable type. A move without a command
/// obeys that of the transition whose time it takes.
bool Engine::must_stop(std::uint32_t unit, const TypeIndex& type) const noexcept {
  const UnitState& state = units_[unit];
  std::uint16_t n = state.transition;
  if (n == kNoTransition) n = transition_without_command(type, state.state, state.target);
  if (n == kNoTransition || type.transitions[n].during == tables::kNoCondition) return false;
  return !truth(general_row(unit).first_condition + type.transitions[n].during);
}

void Engine::step_moving(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type) noexcept {
  const UnitState& state = units_[unit];
  const bool automatic =
      state.transition != kNoTransition && type.transitions[state.transition].on == tables::kNoOperation;
  const bool stop = type.stoppable && must_stop(unit, type);
  if (automatic || type.actuation == tables::Actuation::latched) {
    if (type.stoppable) stop ? stop_midway(unit) : go_on(unit);
    return;
  }
  const std::uint64_t on = operations_on(row, type);
  const auto [forth, back, return_transition] = wishes_of(unit, type, on);
  const bool bistable = type.actuation == tables::Actuation::bistable;
  const bool springs_on = type.actuation == tables::Actuation::spring && state.state != type.rest;
  if (forth && back) {
    found_conflict(unit);
    bistable && !stop ? go_on(unit) : stop_midway(unit);
  } else if (back) {
    turn_round(unit, row, type, return_transition);
  } else if (forth || bistable || springs_on) {
    stop ? stop_midway(unit) : go_on(unit);
  } else if (type.actuation == tables::Actuation::spring) {
    turn_round(unit, row, type, kNoTransition);
  } else {
    stop_midway(unit);
    if (on == 0) return;
    units_[unit].flags |= kStopped;
    suspects_ |= suspect(tables::FindingKind::stopped_under_another_command);
  }
}

void Engine::turn_round(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                        std::uint16_t transition) noexcept {
  UnitState& state = units_[unit];
  const tables::Time forth = whole(unit);
  const tables::Time travelled = std::max<tables::Time>(0, forth - remaining(unit));
  std::swap(state.state, state.target);
  const tables::Time back = takes(unit, row, type, state.target, transition);
  clear_wheel(unit);
  state.transition = transition;
  if (row.general != 0) general_state(unit).whole = back;
  state.flags &= static_cast<std::uint16_t>(~kMidway);
  if (transition != kNoTransition) {
    operation_words_[row.operation_bit / 64].served |= operation_mask(type.transitions[transition].on)
                                                       << (row.operation_bit % 64);
  }
  stepped(unit, row);
  const tables::Time left = time_back(back, travelled, forth);
  state.due = later(head_->now, left);
  if (left != 0 && state.due != tables::kNever) head_->wheel.insert(units_, unit, state.due);
  queue(unit);
}

void Engine::stop_midway(std::uint32_t unit) noexcept {
  UnitState& state = units_[unit];
  if ((state.flags & kMidway) != 0) return;
  clear_wheel(unit);
  if (state.due != tables::kNever) state.due -= head_->now;
  state.flags |= kMidway;
}

void Engine::go_on(std::uint32_t unit) noexcept {
  UnitState& state = units_[unit];
  if ((state.flags & kMidway) == 0) return;
  state.flags &= static_cast<std::uint16_t>(~kMidway);
  state.due = later(head_->now, state.due);
  if (state.due != tables::kNever) head_->wheel.insert(units_, unit, state.due);
}

/// A draw of the random time to which `time` < 0 of the tables refers, or the result of its formula.
tables::Time Engine::drawn(std::uint32_t unit, const TypeIndex& type, std::uint16_t transition,
                           tables::Time time) noexcept {
  const tables::RandomTime& random = tables_.random_times[static_cast<std::size_t>(-1 - time)];
  if (random.kind == tables::RandomTime::Kind::seconds) return values_.time_of(static_cast<std::uint32_t>(random.a));
  Record& record = records_[general_row(unit).first_record + type.record_of[transition]];
  const std::uint64_t start = draw_start(head_->seed, name_hash(unit), transition, record.draws++);
  return random_time(random, start);
}

tables::Time Engine::after_by_behaviour(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                        std::uint16_t transition) noexcept {
  const GeneralRow& general = general_row(unit);
  const Behaviour* behaviour = behaviour_of(general);
  if (behaviour->after == nullptr) return after_by_model(unit, row, type, transition);
  BehaviourView view(*this, unit, general.behaviour);
  return std::max<tables::Time>(0, behaviour->after(view, transition));
}

/// The travel time of a unit with a custom behavior, or that a malfunction slows.
tables::Time Engine::takes_otherwise(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                     std::uint8_t target, std::uint16_t transition) noexcept {
  const tables::Time time = behaves(unit) ? takes_by_behaviour(unit, row, type, target, transition)
                                          : takes_by_model(unit, row, type, target, transition);
  return (units_[unit].flags & kSlowed) != 0 ? malfunctions_.slowed(unit, row, time) : time;
}

tables::Time Engine::takes_by_behaviour(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                        std::uint8_t target, std::uint16_t transition) noexcept {
  const GeneralRow& general = general_row(unit);
  const Behaviour* behaviour = behaviour_of(general);
  if (behaviour->takes == nullptr) return takes_by_model(unit, row, type, target, transition);
  BehaviourView view(*this, unit, general.behaviour, target);
  return std::max<tables::Time>(0, behaviour->takes(view, transition));
}

std::uint16_t Engine::transition_without_command(const TypeIndex& type, std::uint8_t from,
                                                 std::uint8_t to) const noexcept {
  for (const std::uint16_t n : type.from(from)) {
    if (type.transitions[n].to == to && type.transitions[n].on != tables::kNoOperation) return n;
  }
  return kNoTransition;
}

tables::Time Engine::whole(std::uint32_t unit) const noexcept {
  const UnitState& state = units_[unit];
  if ((state.flags & kMoving) == 0) return 0;
  const tables::UnitRow& row = tables_.units[unit];
  if (row.general != 0) return general_state(unit).whole;
  std::uint16_t transition = state.transition;
  const tables::Time time = travel_time(row, index_.types[row.type], state.state, state.target,
                                        transition);  // neither random nor replaced
  return (state.flags & kSlowed) != 0 ? malfunctions_.whole(unit, time) : time;
}

tables::Time Engine::after_left(std::uint32_t unit, std::uint16_t transition) const noexcept {
  const UnitState& state = units_[unit];
  const tables::UnitRow& row = tables_.units[unit];
  const std::uint16_t record_of = index_.types[row.type].record_of[transition];
  const bool counts = row.general != 0 && record_of != kNoRecord && state.holding != 0 && (state.flags & kMoving) == 0;
  if (!counts) return tables::kNever;
  const Record& record = records_[general_row(unit).first_record + record_of];
  if (record.holds == 0 || record.ready == tables::kNever) return tables::kNever;
  return (state.flags & kHalted) != 0 ? record.ready : std::max<tables::Time>(0, record.ready - head_->now);
}

/// Replaces all times of a unit by the time left.
void Engine::halt_times(std::uint32_t unit) noexcept {
  UnitState& state = units_[unit];
  const tables::UnitRow& row = tables_.units[unit];
  clear_wheel(unit);
  if ((state.flags & (kMoving | kMidway)) == kMoving && state.due != tables::kNever) state.due -= head_->now;
  if (row.general == 0) return;
  const GeneralRow& general = general_row(unit);
  const std::uint32_t records = state.holding != 0 ? index_.types[row.type].records : 0;
  for (std::uint32_t r = 0; r < records; ++r) {
    Record& record = records_[general.first_record + r];
    if (record.holds != 0 && record.ready != tables::kNever)
      record.ready = std::max<tables::Time>(0, record.ready - head_->now);
  }
  if (general.behaviour == tables::kNone) return;
  clear_wheel(wheel_entry_of_behaviour(general.behaviour));
  tables::Time& wake = behaviour_states_[general.behaviour].wake;
  if (wake != tables::kNever) wake -= head_->now;
}

void Engine::resume_times(std::uint32_t unit) noexcept {
  UnitState& state = units_[unit];
  const tables::UnitRow& row = tables_.units[unit];
  if ((state.flags & (kMoving | kMidway)) == kMoving && state.due != tables::kNever) {
    state.due = later(head_->now, state.due);
    if (state.due > head_->now && state.due != tables::kNever) head_->wheel.insert(units_, unit, state.due);
  }
  if (row.general == 0) return;
  const GeneralRow& general = general_row(unit);
  const std::uint32_t records = state.holding != 0 ? index_.types[row.type].records : 0;
  for (std::uint32_t r = 0; r < records; ++r) {
    Record& record = records_[general.first_record + r];
    if (record.holds != 0) record.ready = later(head_->now, record.ready);  // the next round puts it in the wheel
  }
  if (general.behaviour == tables::kNone) return;
  BehaviourState& behaviour = behaviour_states_[general.behaviour];
  if (behaviour.wake != tables::kNever) wake_at(general.behaviour, later(head_->now, behaviour.wake));
}

}  // namespace symplant::engine
