// How long a move may take by the model.
#include "watch/limits.hpp"

#include <algorithm>
#include <optional>

namespace symplant::watch {
namespace {

using DurationKind = description::Duration::Kind;

std::optional<Range> range_of(const description::Duration& duration) {
  switch (duration.kind) {
    case DurationKind::fixed:
      return Range{duration.a, duration.a};
    case DurationKind::uniform:
      return Range{duration.a, duration.b};
    case DurationKind::normal:
      return Range{std::max<Time>(duration.a - 4 * duration.b, 0), duration.a + 4 * duration.b};
    case DurationKind::seconds:
      break;
  }
  return std::nullopt;
}

Limits limits_of(const model::Transition& transition) {
  const std::optional<Range> after = range_of(transition.after);
  const std::optional<Range> takes = range_of(transition.takes);
  if (!after || !takes) return {};
  return {true, *after, *takes};
}

/// A spring returns in the time of the first transition of that direction that is not automatic.
Limits spring_limits(const model::Unit& unit, std::uint32_t from, std::uint32_t to) {
  for (const model::Transition& transition : unit.transitions) {
    if (transition.from != from || transition.to != to) continue;
    if (transition.on == kNone && !transition.spring_return) continue;
    const std::optional<Range> takes = range_of(transition.takes);
    return takes ? Limits{true, {}, *takes} : Limits{};
  }
  return {true, {}, {unit.travel, unit.travel}};
}

}  // namespace

Limits limits_of(const model::Unit& unit, const observe::Move& move) {
  if (move.spring_return) return spring_limits(unit, move.from, move.to);
  if (move.transition == kNone) return {};
  return limits_of(unit.transitions[move.transition]);
}

Time longest_move(const model::Unit& unit) {
  Time longest = unit.actuation == tables::Actuation::spring ? unit.travel : kUnknown;
  for (const model::Transition& transition : unit.transitions) {
    const Limits limits = limits_of(transition);
    if (!limits.known) return kUnknown;
    longest = std::max(longest, limits.total().most);
  }
  return longest;
}

Time Margin::of(Time most) const {
  return std::max(static_cast<Time>(share * static_cast<double>(most)), 2 * resolution);
}

Time Margin::missing_after(Time most) const { return std::max(3 * most, most + of(most)); }

}  // namespace symplant::watch
