// SP612 zero-time-loop: automatic transitions form a cycle that takes no time.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "check/reachability/reach.hpp"
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kZeroTimeLoopPage =
    R"(Automatic transitions without a condition (or with one that always holds) lead from a state back to it, and all their `after`
and `takes` are 0.

**What the model loses.** The device would circle forever within one instant. The running plant stops this after 200 rounds: it
reports the device and freezes it until reset (*instantaneous loop*).

**How to fix it.** Give one of the transitions a time (`"after": "1s"`) or a condition (`when`).
)";

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

const Rule kZeroTimeLoop{{"SP612", "zero-time-loop", diag::Severity::warning,
                          "automatic transitions form a cycle that takes no time", kZeroTimeLoopPage},
                         check_zero_time_loop};

}  // namespace symplant::check
