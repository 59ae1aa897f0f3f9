// Moving units: the effect of their operations (docs/model.md, "Commands during a move").
#include <algorithm>
#include <utility>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/wide.hpp"

namespace symplant::engine {
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

}  // namespace symplant::engine
