// Rules: states that a description makes unreachable or endless.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "check/reachability/reach.hpp"
#include "check/rules.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

std::string_view reason(Blocked blocked) {
  switch (blocked) {
    case Blocked::contradiction:
      return "a transition to it, but its condition can never hold";
    case Blocked::waits:
      return "a transition to it, but its condition waits for a state that nothing leads to";
    case Blocked::overtaken:
      return "a transition to it, but an automatic transition leaves its first state before";
    case Blocked::no:
      break;
  }
  return "a transition to it, but from a state that nothing leads to";
}

diag::Location position_of_state(const model::PlantModel& plant, const model::Unit& unit, const model::State& state) {
  for (std::size_t i = 0; i < unit.described->states.size(); ++i) {
    if (text::equal_ignoring_case(unit.described->states[i], state.name)) {
      return described_location(plant, unit,
                                description::key_pointer(*unit.described, description::DeviceKey::states) / i);
    }
  }
  diag::Location location = state.event != model::kNone ? location_of(plant, event_of(plant, unit, state.event))
                            : state.operation != model::kNone
                                ? location_of(plant, operation_of(plant, unit, state.operation))
                                : location_of(plant, first_symbol_of(plant, unit));
  return location_of(std::move(location), transitions_pointer(unit));
}

void check_unreachable_state(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (!is_described(subject)) return;
  const Reach reach(plant);
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    const model::Unit& unit = plant.units[u];
    if (unit.described == nullptr) continue;
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      if (reach.settled(u, s) || unled(subject, unit, s) != Unled::no) continue;
      std::vector<diag::Related> routes;
      bool reported = true;  // SP614 reports it
      for (const model::Transition& transition : unit.transitions) {
        if (transition.to != s || transition.given == model::kNone || routes.size() == 5) continue;
        const Blocked blocked = reach.blocked(u, transition);
        reported = reported && blocked == Blocked::contradiction;
        const bool by_condition = blocked == Blocked::contradiction || blocked == Blocked::waits;
        routes.push_back(
            {described_location(plant, unit, transition_pointer(unit, transition, by_condition ? "when" : "")),
             std::string(reason(blocked))});
      }
      if (reported && !routes.empty()) continue;
      std::string message = fmt::format(
          "nothing leads to `{}` of `{}`, only a scenario or a person can put it there: {}", unit.states[s].name,
          unit.path, routes.empty() ? "add a transition that leads there" : "see why the transitions to it never fire");
      diagnostics.add(rule.info, about(unit), std::move(message), position_of_state(plant, unit, unit.states[s]),
                      std::move(routes));
    }
  }
}

/// An operation that leads to another state; kNone if there is none.
std::uint32_t command_away(const model::Unit& unit, std::uint32_t state) {
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    if (s != state && unit.states[s].operation != model::kNone) return unit.states[s].operation;
  }
  const auto found = std::find_if(
      unit.transitions.begin(), unit.transitions.end(),
      [&](const model::Transition& transition) { return transition.on != model::kNone && transition.to != state; });
  return found == unit.transitions.end() ? model::kNone : found->on;
}

void check_state_never_left(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (!is_described(subject)) return;
  const Reach reach(plant);
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    const model::Unit& unit = plant.units[u];
    if (unit.described == nullptr || !unit.moves()) continue;
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      if (!reach.settled(u, s) || reach.can_leave(u, s)) continue;
      const std::uint32_t command = command_away(unit, s);
      if (command == model::kNone) continue;
      std::vector<diag::Related> routes;
      for (const model::Transition& transition : unit.transitions) {
        if (transition.from != s || transition.given == model::kNone || routes.size() == 5) continue;
        routes.push_back({described_location(plant, unit, transition_pointer(unit, transition, "when")),
                          reach.blocked(u, transition) == Blocked::waits
                              ? "a transition out of it, but its condition waits for a state that nothing leads to"
                              : "a transition out of it, but its condition can never hold"});
      }
      std::string message = fmt::format(
          "`{}` never leaves `{}`, though `{}` commands it away: {}", unit.path, unit.states[s].name,
          operation_of(plant, unit, command).name(),
          routes.empty() ? "add a transition that leads out" : "see why the transitions out of it never fire");
      diagnostics.add(rule.info, about(unit), std::move(message),
                      described_location(plant, unit, transitions_pointer(unit)), std::move(routes));
    }
  }
}

constexpr std::uint32_t kNowhere = model::kNone;

/// Where a unit that is settled in a state is taken within the same instant, whatever else there is: a state -> the
/// transition. Of several the first fires.
std::vector<std::uint32_t> instant_transitions(const model::PlantModel& plant, const model::Unit& unit) {
  std::vector<std::uint32_t> first(unit.states.size(), kNowhere);
  for (std::uint32_t i = 0; i < unit.transitions.size(); ++i) {
    const model::Transition& transition = unit.transitions[i];
    if (transition.on != model::kNone || transition.spring_return || !transition.after.is_zero() ||
        first[transition.from] != kNowhere)
      continue;
    if (transition.when == model::kNone || decide(unit.conditions[transition.when], plant, AllStates(plant)).always()) {
      first[transition.from] = i;
    }
  }
  for (std::uint32_t& transition : first) {
    if (transition != kNowhere && !unit.transitions[transition].takes.is_zero()) transition = kNowhere;
  }
  return first;
}

void check_zero_time_loop(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (!is_described(subject)) return;
  for (const model::Unit& unit : plant.units) {
    // The user's code has separate times.
    if (unit.described == nullptr || unit.has_behaviour()) continue;
    const std::vector<std::uint32_t> routes = instant_transitions(plant, unit);
    std::vector<std::uint32_t> seen_from(unit.states.size(), kNowhere);
    for (std::uint32_t start = 0; start < unit.states.size(); ++start) {
      std::uint32_t at = start;
      while (routes[at] != kNowhere && seen_from[at] == kNowhere) {
        seen_from[at] = start;
        at = unit.transitions[routes[at]].to;
      }
      if (routes[at] == kNowhere || seen_from[at] != start) continue;  // it ends, or is reported already
      std::string circle = "`" + unit.states[at].name + "`";
      std::vector<diag::Related> others;
      const std::uint32_t first = at;
      do {
        const model::Transition& transition = unit.transitions[routes[at]];
        if (at != first) {
          others.push_back(
              {described_location(plant, unit, transition_pointer(unit, transition)), "and this one leads on"});
        }
        at = transition.to;
        circle += " -> `" + unit.states[at].name + "`";
      } while (at != first);
      diagnostics.add(
          rule.info, about(unit),
          fmt::format(
              "`{}` goes {} without a command and without time passing, so it freezes when it runs: give one of "
              "these transitions an `after`, a `takes` or a `when`",
              unit.path, circle),
          described_location(plant, unit, transition_pointer(unit, unit.transitions[routes[first]])),
          std::move(others));
    }
  }
}

}  // namespace

const Rule kUnreachableState{
    {"SP610", "unreachable-state", diag::Severity::warning, "nothing leads to a state",
     R"(No chain of transitions leads from the initial state of a device to this state. There is no transition to it, or each of them
begins in a state that is not reached either, waits for a condition that cannot hold, or is overtaken by an automatic
transition without condition and time. The check assumes that the PLC may write anything, and that a device without a driver
(push button, door) may be in any state. It also finds two devices that wait for each other.

**What the model loses.** The device never enters the state, so its event never comes on, and what waits for the event waits
forever. Only a scenario or a person at the panel can put the device there.

**How to fix it.** Add a transition to the state in plant.json, remove `"only": true`, or fix the condition that the related
rows show. If only a scenario should enter the state (a fault, for example), ignore the finding in plant.json:
`"check": { "ignore": [ { "rule": "unreachable-state", "symbols": "THE_DEVICE", "why": "..." } ] }`.
)"},
    check_unreachable_state};

const Rule kStateNeverLeft{
    {"SP611", "state-never-left", diag::Severity::warning,
     "a state cannot be left though a command for another is there",
     R"(A device can come into this state, but no transition leaves it, although an operation commands another state. The transitions
out of it are missing, or their conditions can never hold.

**What the model loses.** The device stays in the state forever and ignores its operations. A program that commands it away
waits forever.

**How to fix it.** Add a transition out of the state in plant.json, remove `"only": true` so that the transitions of the
operations are derived again, or fix the conditions that the related rows show.
)"},
    check_state_never_left};

const Rule kZeroTimeLoop{
    {"SP612", "zero-time-loop", diag::Severity::warning, "automatic transitions form a cycle that takes no time",
     R"(Automatic transitions without a condition (or with one that always holds) lead from a state back to it, and all their `after`
and `takes` are 0.

**What the model loses.** The device would circle forever within one instant. The running plant stops this after 200 rounds: it
reports the device and freezes it until reset (*instantaneous loop*).

**How to fix it.** Give one of the transitions a time (`"after": "1s"`) or a condition (`when`).
)"},
    check_zero_time_loop};

}  // namespace symplant::check
