// One step of one unit in a round. A unit reads its own state and operations only, so the order of units never shows.
#include <algorithm>
#include <bit>

#include "symplant/core/engine.hpp"

namespace symplant::core {
namespace {

constexpr std::uint64_t bit(std::uint8_t operation) noexcept { return std::uint64_t{1} << operation; }

/// `a` + `b`, or kNever where that lies beyond all time.
constexpr Time later(Time a, Time b) noexcept { return b > kNever - a ? kNever : a + b; }

/// floor(back * travelled / forth), as a move that is turned round has it left.
Time time_back(Time back, Time travelled, Time forth) noexcept {
  if (forth == 0) return 0;
#if defined(__SIZEOF_INT128__)
  __extension__ using Wide = unsigned __int128;
  return static_cast<Time>(static_cast<Wide>(back) * static_cast<Wide>(travelled) / static_cast<Wide>(forth));
#else
#error "the engine needs a 128-bit integer type"
#endif
}

}  // namespace

std::uint64_t Engine::operations_on(const UnitRow& row, const TypeIndex& type) const noexcept {
  const std::uint32_t word = row.operation_bit / 64;
  if (type.operations == 0) return 0;
  return ((operations[word] & ~disarmed[word]) >> (row.operation_bit % 64)) & type.operations;
}

Time Engine::takes(const UnitRow& row, std::uint16_t transition) const noexcept {
  const std::uint32_t place = transition == kNoTransition ? 0 : transition + std::uint32_t{1};
  return tables_.times[row.times + place].takes;
}

Time Engine::after(const UnitRow& row, std::uint16_t transition) const noexcept {
  return tables_.times[row.times + transition + std::uint32_t{1}].after;
}

std::uint16_t Engine::way_without_command(const TypeIndex& type, std::uint8_t from, std::uint8_t to) const noexcept {
  for (const std::uint16_t n : type.from(from)) {
    if (type.transitions[n].to == to && type.transitions[n].on != kNoOperation) return n;
  }
  return kNoTransition;
}

void Engine::stepped(std::uint32_t unit) noexcept {
  if ((units[unit].flags & kStepped) != 0) return;
  units[unit].flags |= kStepped;
  stepped_.add(unit);
}

void Engine::time(std::uint32_t unit, Time duration) noexcept {
  const Time due = later(head->now, duration);
  units[unit].due = due;
  if (duration == 0) {
    queue(unit);
  } else if (due != kNever) {
    head->wheel.insert(units, unit, due);
  }
}

void Engine::step(std::uint32_t unit) noexcept {
  const UnitRow& row = tables_.units[unit];
  const TypeIndex& type = index_.types[row.type];
  if ((units[unit].flags & kMoving) != 0) {
    step_moving(unit, row, type);
  } else {
    step_settled(unit, row, type);
  }
}

void Engine::step_settled(std::uint32_t unit, const UnitRow& row, const TypeIndex& type) noexcept {
  const std::uint8_t here = units[unit].state;
  if (type.automatic[here] && fire_automatic(unit, row, type)) return;

  const std::uint64_t on = operations_on(row, type);
  std::uint64_t served = 0;  // operations that are the `on` of a ready transition
  std::uint8_t wanted = kNoState;
  std::uint16_t first = kNoTransition;
  bool conflict = false;
  if ((on & type.starts[here]) != 0) {
    for (const std::uint16_t n : type.from(here)) {
      const Transition& transition = type.transitions[n];
      if (transition.on == kNoOperation || (on & bit(transition.on)) == 0) continue;
      served |= bit(transition.on);
      if (first == kNoTransition) {
        first = n;
        wanted = transition.to;
      } else if (transition.to != wanted) {
        conflict = true;
      }
    }
  }
  const bool stay_wanted = (on & type.leads[here] & ~served) != 0;
  if (first != kNoTransition) {
    if (!conflict && !stay_wanted) leave(unit, row, type, wanted, first);
  } else if (!stay_wanted && type.actuation == Actuation::spring && here != type.rest) {
    leave(unit, row, type, type.rest, kNoTransition);
  }
}

bool Engine::fire_automatic(std::uint32_t unit, const UnitRow& row, const TypeIndex& type) noexcept {
  const UnitState& state = units[unit];
  for (const std::uint16_t n : type.from(state.state)) {
    const Transition& transition = type.transitions[n];
    if (transition.on != kNoOperation || later(state.mark, after(row, n)) > head->now) continue;
    if (type.actuation == Actuation::latched && type.operations != 0) {
      const std::uint64_t leading = type.leads[state.state] << (row.operation_bit % 64);
      disarmed[row.operation_bit / 64] |= leading & operations[row.operation_bit / 64];
    }
    leave(unit, row, type, transition.to, n);
    return true;
  }
  return false;
}

void Engine::await_automatic(std::uint32_t unit, const UnitRow& row, const TypeIndex& type) noexcept {
  const std::uint8_t here = units[unit].state;
  if (!type.automatic[here]) return;
  Time earliest = kNever;
  for (const std::uint16_t n : type.from(here)) {
    if (type.transitions[n].on == kNoOperation) earliest = std::min(earliest, after(row, n));
  }
  if (earliest != 0) time(unit, earliest);  // else it is ready in the round that comes anyway
}

void Engine::leave(std::uint32_t unit, const UnitRow& row, const TypeIndex& type, std::uint8_t target,
                   std::uint16_t transition) noexcept {
  UnitState& state = units[unit];
  if ((state.flags & kTimed) != 0) head->wheel.remove(units, unit);
  write_events(row, type.leave[state.state], false);
  stepped(unit);
  state.target = target;
  state.transition = transition;
  const bool automatic = transition != kNoTransition && type.transitions[transition].on == kNoOperation;
  const std::uint16_t timed_as =
      transition != kNoTransition ? transition : way_without_command(type, state.state, target);
  const Time duration = takes(row, timed_as);
  if (duration == 0) {
    settle(unit, row, type);
    return;
  }
  state.flags |= kMoving;
  state.mark = duration;
  time(unit, duration);
  if (!automatic && type.actuation != Actuation::latched) queue(unit);
}

void Engine::settle(std::uint32_t unit, const UnitRow& row, const TypeIndex& type) noexcept {
  UnitState& state = units[unit];
  state.state = state.target;
  state.flags &= static_cast<std::uint8_t>(~kMoving);
  state.mark = head->now;
  write_events(row, type.enter[state.state], true);
  stepped(unit);
  await_automatic(unit, row, type);
  queue(unit);
}

void Engine::step_moving(std::uint32_t unit, const UnitRow& row, const TypeIndex& type) noexcept {
  UnitState& state = units[unit];
  if ((state.flags & kStanding) == 0 && state.due == head->now) {
    if ((state.flags & kTimed) != 0) head->wheel.remove(units, unit);
    settle(unit, row, type);
    return;
  }
  const bool automatic = state.transition != kNoTransition && type.transitions[state.transition].on == kNoOperation;
  if (automatic || type.actuation == Actuation::latched) return;

  const std::uint64_t on = operations_on(row, type);
  std::uint64_t forth = 0;  // operations of the way under way
  for (const std::uint16_t n : type.from(state.state)) {
    const Transition& transition = type.transitions[n];
    if (transition.to == state.target && transition.on != kNoOperation) forth |= bit(transition.on);
  }
  std::uint16_t back = kNoTransition;
  for (const std::uint16_t n : type.from(state.target)) {
    const Transition& transition = type.transitions[n];
    if (transition.to != state.state || transition.on == kNoOperation) continue;
    if ((on & ~forth & bit(transition.on)) == 0) continue;
    back = n;
    break;
  }
  const bool forth_on = (on & forth) != 0;
  const bool back_on = back != kNoTransition;
  if (forth_on && back_on) {
    stand_still(unit);
  } else if (back_on || (!forth_on && state.state == type.rest)) {
    turn_round(unit, row, type, back);
  } else {
    go_on(unit);
  }
}

void Engine::turn_round(std::uint32_t unit, const UnitRow& row, const TypeIndex& type,
                        std::uint16_t transition) noexcept {
  UnitState& state = units[unit];
  const Time remaining = (state.flags & kStanding) != 0 ? state.due : state.due - head->now;
  if ((state.flags & kTimed) != 0) head->wheel.remove(units, unit);
  std::swap(state.state, state.target);
  state.transition = transition;
  state.flags &= static_cast<std::uint8_t>(~kStanding);
  const Time forth = state.mark;
  state.mark =
      takes(row, transition != kNoTransition ? transition : way_without_command(type, state.state, state.target));
  stepped(unit);
  time(unit, time_back(state.mark, forth - remaining, forth));
  queue(unit);
}

void Engine::stand_still(std::uint32_t unit) noexcept {
  UnitState& state = units[unit];
  if ((state.flags & kStanding) != 0) return;
  if ((state.flags & kTimed) != 0) head->wheel.remove(units, unit);
  state.due -= head->now;
  state.flags |= kStanding;
  stepped(unit);
}

void Engine::go_on(std::uint32_t unit) noexcept {
  UnitState& state = units[unit];
  if ((state.flags & kStanding) == 0) return;
  state.flags &= static_cast<std::uint8_t>(~kStanding);
  stepped(unit);
  time(unit, state.due);
}

}  // namespace symplant::core
