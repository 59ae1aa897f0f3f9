// SP610 unreachable-state: nothing leads to a state.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "check/reachability/reach.hpp"
#include "check/rules.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kUnreachableStatePage =
    R"(No chain of transitions leads from the initial state of a device to this state. There is no transition to it, or each of them
begins in a state that is not reached either, waits for a condition that cannot hold, or is overtaken by an automatic
transition without condition and time. The check assumes that the PLC may write anything, and that a device without a driver
(push button, door) may be in any state. It also finds two devices that wait for each other.

**What the model loses.** The device never enters the state, so its event never comes on, and what waits for the event waits
forever. Only a scenario or a person at the panel can put the device there.

**How to fix it.** Add a transition to the state in plant.json, remove `"only": true`, or fix the condition that the related
rows show. If only a scenario should enter the state (a fault, for example), ignore the finding in plant.json:
`"check": { "ignore": [ { "rule": "unreachable-state", "symbols": "THE_DEVICE", "why": "..." } ] }`.
)";

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

}  // namespace

const Rule kUnreachableState{
    {"SP610", "unreachable-state", diag::Severity::warning, "nothing leads to a state", kUnreachableStatePage},
    check_unreachable_state};

}  // namespace symplant::check
