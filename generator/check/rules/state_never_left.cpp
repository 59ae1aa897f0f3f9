// SP611 state-never-left: a state cannot be left though a command for another is there.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "check/reachability/reach.hpp"
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kStateNeverLeftPage =
    R"(A device comes into a state and nothing leads out of it, though the PLC has an operation that commands another one: with
`"only": true` no transition begins there, or each that does waits for a condition that cannot hold.

**What the model loses.** Once there, the device stays for ever and ignores its operations. A program that commands it away
waits for ever.

**How to fix it.** Give the device a transition out of the state in plant.json, take `"only": true` away so that the ways of
its operations are derived again, or mend the conditions that the related places show.
)";

/// An operation that leads to another state; kNone where there is none.
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
                              ? "a way out, but its condition waits for a state that nothing leads to"
                              : "a way out, but its condition can never hold"});
      }
      std::string message =
          fmt::format("`{}` never leaves `{}`, though `{}` commands it away: {}", unit.path, unit.states[s].name,
                      operation_of(plant, unit, command).name(),
                      routes.empty() ? "give it a transition that leads out" : "see why the ways out are not taken");
      diagnostics.add(rule.info, about(unit), std::move(message),
                      described_location(plant, unit, transitions_pointer(unit)), std::move(routes));
    }
  }
}

}  // namespace

const Rule kStateNeverLeft{{"SP611", "state-never-left", diag::Severity::warning,
                            "a state cannot be left though a command for another is there", kStateNeverLeftPage},
                           check_state_never_left};

}  // namespace symplant::check
