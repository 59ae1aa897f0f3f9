// One unit's step: settling, firing, leaving for rest (docs/model.md, "One instant"); moving units have a separate
// file.
#include <set>

#include "support/reference/round.hpp"

namespace symplant::reference {
namespace {

bool behaves(const UnitRules& unit) { return unit.behaviour != nullptr; }

/// The transitions from the settled state whose cause has held for their `after`, in the order of the table.
std::vector<std::uint16_t> ready_transitions(Round& round, std::uint32_t unit) {
  const UnitRules& rules = round.of(unit);
  std::vector<std::uint16_t> ready;
  for (std::uint16_t i = 0; i < rules.transitions.size(); ++i) {
    const Transition& route = rules.transitions[i];
    // A spring return is never ready by itself.
    if (route.from != round.old.units[unit].state || (!route.automatic && !route.commanded())) continue;
    const bool cause = (route.automatic || operation_on(round, unit, route.on)) && when_holds(round, unit, route);
    TransitionWorld& world = round.next.units[unit].transitions[i];
    if (!cause) {
      if (world.holds) ++round.counters[Counted::after_broken];
      world.holds = false;
      world.left = 0;
      continue;
    }
    if (!remembers(rules, route)) {
      ready.push_back(i);
      continue;
    }
    if (!world.holds) {
      world.holds = true;
      world.left = after_of(round, unit, i);
    }
    if (world.left == 0) ready.push_back(i);
  }
  return ready;
}

void disarm_leading_to(Round& round, std::uint32_t unit, std::uint8_t state) {
  const UnitRules& rules = round.of(unit);
  for (std::uint32_t i = 0; i < rules.operations.size(); ++i) {
    if (!is_on(round.rules, round.old, rules.operations[i]) || !rules.leads_to(i, state)) continue;
    OperationWorld& operation = round.next.units[unit].operations[i];
    if (operation.armed) ++round.counters[Counted::disarmed_automatic];
    operation.armed = false;
  }
}

/// Leaves the settled state. `way`: kNoTransition without a command.
void depart(Round& round, std::uint32_t unit, std::uint16_t route, std::uint8_t to, Time takes) {
  UnitWorld& world = round.next.units[unit];
  const std::uint8_t from = world.state;
  end_holds(world);
  leave(round, unit, from);
  world.target = to;
  if (takes == 0) {
    ++round.counters[Counted::fired_takes_zero];
    world.state = to;
    enter(round, unit, to);
    return;
  }
  world.moving = true;
  world.stopped_midway = world.stopped_by_while = world.returning = false;
  world.moving_now = route;
  world.automatic = route != kNoTransition && round.of(unit).transitions[route].automatic;
  world.remaining = takes;
  world.whole = takes;
}

void depart_without_command(Round& round, std::uint32_t unit, std::uint8_t to) {
  const std::uint8_t from = round.old.units[unit].state;
  depart(round, unit, kNoTransition, to, takes_of(round, unit, kNoTransition, from, to));
}

// The user code's time is requested first.
void fire(Round& round, std::uint32_t unit, std::uint16_t number) {
  const UnitRules& rules = round.of(unit);
  const Transition& route = rules.transitions[number];
  const Time takes = takes_of(round, unit, number, route.from, route.to);
  const bool latched = rules.actuation == tables::Actuation::latched;
  ++round.counters[route.automatic ? Counted::automatic_fired : Counted::commanded_fired];
  if (route.automatic && latched) disarm_leading_to(round, unit, route.from);
  if (route.commanded() && route.once && latched) {
    ++round.counters[Counted::disarmed_once];
    round.next.units[unit].operations[route.on].armed = false;
  }
  if (route.commanded()) serve(round, unit, route.on);
  depart(round, unit, number, route.to, takes);
}

/// The first ready automatic transition, or, if it has a weight, one that is drawn of those with a weight.
std::uint16_t automatic_to_fire(Round& round, std::uint32_t unit, const std::vector<std::uint16_t>& ready) {
  const std::vector<Transition>& transitions = round.of(unit).transitions;
  if (transitions[ready.front()].weight == 0) return ready.front();
  std::uint64_t sum = 0;
  int candidates = 0;
  for (const std::uint16_t i : ready) {
    sum += transitions[i].weight;
    candidates += transitions[i].weight != 0 ? 1 : 0;
  }
  ++round.counters[candidates == 1 ? Counted::weight_of_one : Counted::weight_of_several];
  std::uint64_t drawn = draw_weight(round, unit, ready.front(), sum);
  for (const std::uint16_t i : ready) {
    if (drawn < transitions[i].weight) return i;
    drawn -= transitions[i].weight;
  }
  return ready.front();
}

/// The wanted states: the targets of the ready commanded transitions, the unit's own state, a behavior's.
std::set<std::uint8_t> wanted_states(Round& round, std::uint32_t unit, const std::vector<std::uint16_t>& ready) {
  const UnitRules& rules = round.of(unit);
  const std::uint8_t own = round.old.units[unit].state;
  std::set<std::uint8_t> wanted;
  std::set<std::uint32_t> commanding;
  for (const std::uint16_t i : ready) {
    wanted.insert(rules.transitions[i].to);
    commanding.insert(rules.transitions[i].on);
  }
  for (std::uint32_t i = 0; i < rules.operations.size(); ++i) {
    if (rules.leads_to(i, own) && operation_on(round, unit, i) && commanding.count(i) == 0) wanted.insert(own);
  }
  const std::uint8_t more = wanted_by_behaviour(round, unit);
  if (more != tables::kNoState) wanted.insert(more);
  return wanted;
}

/// Step 3 of docs/model.md.
bool step_settled(Round& round, std::uint32_t unit) {
  const UnitRules& rules = round.of(unit);
  const std::uint8_t own = round.old.units[unit].state;
  std::vector<std::uint16_t> commanded;
  std::vector<std::uint16_t> automatic;
  for (const std::uint16_t i : ready_transitions(round, unit))
    (rules.transitions[i].automatic ? automatic : commanded).push_back(i);
  if (!automatic.empty()) {
    fire(round, unit, automatic_to_fire(round, unit, automatic));
    return true;
  }
  const std::set<std::uint8_t> wanted = wanted_states(round, unit, commanded);
  if (wanted.size() > 1) {
    ++round.counters[Counted::stayed_conflicting];
    round.notes.looks[unit].conflicting = true;
    return false;
  }
  if (wanted.size() == 1 && *wanted.begin() != own) {
    if (!commanded.empty()) {
      fire(round, unit, commanded.front());
    } else {
      ++round.counters[Counted::wanted_transition];
      depart_without_command(round, unit, *wanted.begin());
    }
    return true;
  }
  if (wanted.size() == 1) {
    ++round.counters[Counted::stayed_own_state_wanted];
    return false;
  }
  if (!rules.spring() || own == rules.rest) return false;
  ++round.counters[Counted::spring_left_for_rest];
  depart_without_command(round, unit, static_cast<std::uint8_t>(rules.rest));
  return true;
}

void settle(Round& round, std::uint32_t unit) {
  ++round.counters[Counted::settle];
  UnitWorld& world = round.next.units[unit];
  world.state = world.target;
  world.moving = false;
  world.stopped_midway = world.stopped_by_while = world.returning = false;
  world.automatic = false;
  world.moving_now = kNoTransition;
  world.remaining = 0;
  world.whole = 0;
  enter(round, unit, world.state);
}

}  // namespace

bool operation_on(const Round& round, std::uint32_t unit, std::uint32_t operation) {
  const std::uint32_t symbol = round.of(unit).operations[operation];
  return is_on(round.rules, round.old, symbol) && round.old.units[unit].operations[operation].armed;
}

bool when_holds(const Round& round, std::uint32_t unit, const Transition& route) {
  return route.when == kNone || holds(*round.of(unit).conditions[route.when], round.old);
}

std::uint8_t wanted_by_behaviour(Round& round, std::uint32_t unit) {
  const UnitRules& rules = round.of(unit);
  if (!behaves(rules) || rules.behaviour->wanted == nullptr) return tables::kNoState;
  View view(round, unit);
  const std::uint8_t wanted = rules.behaviour->wanted(view);
  // An unknown state counts as no state.
  return wanted < rules.states.size() ? wanted : tables::kNoState;
}

void serve(Round& round, std::uint32_t unit, std::uint32_t operation) { round.notes.served[unit][operation] = true; }

// An event that follows an event of another unit is left to that unit.
void write_event(const Rules& rules, World& world, std::uint32_t symbol, std::uint64_t value) {
  const std::uint32_t first = rules.leader(symbol);
  const bool own = rules.model->symbols[first].unit == rules.model->symbols[symbol].unit;
  if (first != symbol && !own && rules.moved(first)) return;
  const std::uint64_t bit = rules.turned(symbol, value);
  for (const std::uint32_t each : rules.together(symbol)) world.symbols[each].value = bit;
}

void leave(Round& round, std::uint32_t unit, std::uint8_t state) {
  const UnitRules& rules = round.of(unit);
  for (const auto& [event, on] : rules.states[state].leave) {
    write_event(round.rules, round.next, rules.events[event], on ? 1 : 0);
  }
  if (!behaves(rules) || rules.behaviour->left == nullptr) return;
  View view(round, unit);
  rules.behaviour->left(view, state);
}

void enter(Round& round, std::uint32_t unit, std::uint8_t state) {
  const UnitRules& rules = round.of(unit);
  for (const auto& [event, on] : rules.states[state].enter) {
    write_event(round.rules, round.next, rules.events[event], on ? 1 : 0);
  }
  if (!behaves(rules) || rules.behaviour->entered == nullptr) return;
  View view(round, unit);
  rules.behaviour->entered(view, state);
}

void end_holds(UnitWorld& unit) {
  for (TransitionWorld& transition : unit.transitions) {
    transition.holds = false;
    transition.left = 0;
  }
}

bool step(Round& round, std::uint32_t unit) {
  const UnitWorld& world = round.old.units[unit];
  if (world.disabled || world.frozen) return false;
  bool stepped = false;
  if (world.until_woken == 0) {
    round.next.units[unit].until_woken = -1;
    if (behaves(round.of(unit)) && round.of(unit).behaviour->woken != nullptr) {
      ++round.counters[Counted::woken];
      View view(round, unit);
      round.of(unit).behaviour->woken(view);
      stepped = true;
    }
  }
  if (!world.moving) return step_settled(round, unit) || stepped;
  if (world.remaining > 0) return step_moving(round, unit) || stepped;
  settle(round, unit);
  return true;
}

}  // namespace symplant::reference
