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
    R"(A device can come into this state, but no transition leaves it, although an operation commands another state. The transitions
out of it are missing, or their conditions can never hold.

**What the model loses.** The device stays in the state forever and ignores its operations. A program that commands it away
waits forever.

**How to fix it.** Add a transition out of the state in plant.json, remove `"only": true` so that the transitions of the
operations are derived again, or fix the conditions that the related rows show.
)";

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

}  // namespace

const Rule kStateNeverLeft{{"SP611", "state-never-left", diag::Severity::warning,
                            "a state cannot be left though a command for another is there", kStateNeverLeftPage},
                           check_state_never_left};

}  // namespace symplant::check
