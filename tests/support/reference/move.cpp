// A moving unit: the table of four actuations (docs/model.md, "Commands during a move").
#include <algorithm>

#include "support/reference/round.hpp"

namespace symplant::reference {
namespace {

__extension__ using Wide = __int128;

struct Command {
  bool forth = false;
  bool back = false;
  std::uint16_t back_by = kNoTransition;  ///< the first transition that counts as a return
};

bool is_on_of(const UnitRules& unit, std::uint32_t operation, std::uint8_t from, std::uint8_t to) {
  for (const Transition& transition : unit.transitions) {
    if (transition.from == from && transition.to == to && transition.on == operation) return true;
  }
  return false;
}

Command command_of(Round& round, std::uint32_t unit) {
  const UnitRules& rules = round.of(unit);
  const std::uint8_t from = round.old.units[unit].state;
  const std::uint8_t to = round.old.units[unit].target;
  Command command;
  for (std::uint32_t i = 0; i < rules.operations.size(); ++i) {
    if (operation_on(round, unit, i) && is_on_of(rules, i, from, to)) command.forth = true;
  }
  const std::uint8_t wanted =
      rules.actuation == tables::Actuation::latched ? tables::kNoState : wanted_by_behaviour(round, unit);
  if (wanted == to) command.forth = true;
  if (wanted == from) command.back = true;
  for (std::uint16_t i = 0; i < rules.transitions.size(); ++i) {
    const Transition& transition = rules.transitions[i];
    if (transition.from != to || transition.to != from) continue;
    const bool commands = transition.commanded() && operation_on(round, unit, transition.on) &&
                          !is_on_of(rules, transition.on, from, to) && when_holds(round, unit, transition);
    if (!commands) continue;
    command.back = true;
    if (command.back_by == kNoTransition) command.back_by = i;
  }
  return command;
}

/// Returns by a transition, or, with kNoTransition, without a command.
bool turn_round(Round& round, std::uint32_t unit, std::uint16_t transition) {
  ++round.counters[Counted::turned_round];
  UnitWorld& world = round.next.units[unit];
  const std::uint8_t from = world.state;
  const std::uint8_t to = world.target;
  const Time takes = takes_of(round, unit, transition, to, from);
  if (transition != kNoTransition && round.of(unit).transitions[transition].commanded())
    serve(round, unit, round.of(unit).transitions[transition].on);
  const Time gone = std::max<Time>(0, world.whole - world.remaining);
  world.remaining = static_cast<Time>(static_cast<Wide>(takes) * gone / world.whole);
  world.whole = takes;
  world.state = to;
  world.target = from;
  world.moving_now = transition;
  world.stopped_midway = world.stopped_by_while = false;
  world.returning = true;
  return true;
}

/// The `while` of the transition of a move, or of the one that a move without a command takes its time from.
bool while_holds(const Round& round, std::uint32_t unit) {
  const UnitRules& rules = round.of(unit);
  const UnitWorld& world = round.old.units[unit];
  const std::uint16_t source =
      world.moving_now != kNoTransition ? world.moving_now : first_not_automatic(rules, world.state, world.target);
  if (source == kNoTransition || rules.transitions[source].during == kNone) return true;
  return holds(*rules.conditions[rules.transitions[source].during], round.old);
}

bool stop_by_while(Round& round, std::uint32_t unit) {
  const UnitRules& rules = round.of(unit);
  UnitWorld& world = round.next.units[unit];
  const bool begins = !world.stopped_by_while;
  world.stopped_midway = world.stopped_by_while = true;
  if (!begins) return false;
  ++round.counters[Counted::while_stopped];
  if (world.automatic) {
    ++round.counters[Counted::while_stopped_automatic];
  } else if (rules.actuation == tables::Actuation::latched) {
    ++round.counters[Counted::while_stopped_latched];
  }
  if (world.moving_now == kNoTransition) ++round.counters[Counted::while_stopped_without_command];
  if (world.returning) ++round.counters[Counted::while_stopped_on_return];
  return false;
}

bool go_on(Round& round, std::uint32_t unit) {
  UnitWorld& world = round.next.units[unit];
  if (!while_holds(round, unit)) return stop_by_while(round, unit);
  if (world.stopped_midway) ++round.counters[world.stopped_by_while ? Counted::while_resumed : Counted::went_on];
  world.stopped_midway = world.stopped_by_while = false;
  return false;
}

bool stop_midway(Round& round, std::uint32_t unit) {
  UnitWorld& world = round.next.units[unit];
  world.stopped_by_while = false;
  if (!world.stopped_midway) ++round.counters[Counted::stood_still];
  world.stopped_midway = true;
  return false;
}

bool bistable(Round& round, std::uint32_t unit, const Command& command) {
  if (command.forth && command.back) {
    ++round.counters[Counted::bistable_both];
    round.notes.looks[unit].conflicting = true;
    return go_on(round, unit);
  }
  if (command.back) {
    ++round.counters[Counted::bistable_back];
    return turn_round(round, unit, command.back_by);
  }
  ++round.counters[command.forth ? Counted::bistable_forth : Counted::bistable_neither];
  return go_on(round, unit);
}

bool held(Round& round, std::uint32_t unit, const Command& command) {
  if (command.forth && command.back) {
    ++round.counters[Counted::held_both];
    round.notes.looks[unit].conflicting = true;
    return stop_midway(round, unit);
  }
  if (command.back) {
    ++round.counters[Counted::held_back];
    return turn_round(round, unit, command.back_by);
  }
  if (command.forth) {
    ++round.counters[Counted::held_forth];
    return go_on(round, unit);
  }
  ++round.counters[Counted::held_neither];
  round.notes.looks[unit].neither = true;
  return stop_midway(round, unit);
}

bool spring(Round& round, std::uint32_t unit, const Command& command) {
  if (command.forth && command.back) {
    ++round.counters[Counted::spring_both];
    round.notes.looks[unit].conflicting = true;
    return stop_midway(round, unit);
  }
  if (command.back) {
    ++round.counters[Counted::spring_back];
    return turn_round(round, unit, command.back_by);
  }
  if (command.forth) {
    ++round.counters[Counted::spring_forth];
    return go_on(round, unit);
  }
  if (round.old.units[unit].state == round.of(unit).rest) {
    ++round.counters[Counted::spring_neither_from_rest];
    return turn_round(round, unit, kNoTransition);
  }
  ++round.counters[Counted::spring_neither_from_elsewhere];
  return go_on(round, unit);
}

Counted latched_cell(const Command& command) {
  if (command.forth) return command.back ? Counted::latched_both : Counted::latched_forth;
  return command.back ? Counted::latched_back : Counted::latched_neither;
}

}  // namespace

bool step_moving(Round& round, std::uint32_t unit) {
  if (round.old.units[unit].automatic) {
    ++round.counters[Counted::automatic_move_goes_on];
    return go_on(round, unit);
  }
  const Command command = command_of(round, unit);
  switch (round.of(unit).actuation) {
    case tables::Actuation::latched:
      ++round.counters[latched_cell(command)];
      return go_on(round, unit);
    case tables::Actuation::bistable:
      return bistable(round, unit, command);
    case tables::Actuation::held:
      return held(round, unit, command);
    case tables::Actuation::spring:
      return spring(round, unit, command);
  }
  return false;
}

}  // namespace symplant::reference
