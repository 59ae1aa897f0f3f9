// What a recording does not show for certain.
#include <algorithm>

#include "observe/observer_impl.hpp"

namespace symplant::observe {
namespace {

using model::Unit;

/// A state without an event is reached at a time that nothing shows. A unit is taken to have been at rest there if its
/// next move took at most a third of the time since it left the state before, and if the model's travel time was over,
/// too. For others that ask it is there after ten travel times of the model.
constexpr Time kRestShare = 3;
constexpr Time kSureTravels = 10;

}  // namespace

bool Observer::Impl::is_surely_settled(std::uint32_t u) const {
  if (units_[u].at_once || units_[u].rests_since == kUnknown) return true;
  return now_ - units_[u].rests_since >= kSureTravels * longest_travel(plant_.units[u], units_[u].state);
}

Time Observer::Impl::longest_travel(const Unit& unit, std::uint32_t to) {
  Time longest = 0;
  for (const model::Transition& transition : unit.transitions) {
    using Kind = description::Duration::Kind;
    if (transition.to != to || transition.takes.kind == Kind::seconds) continue;
    longest = std::max(longest, transition.takes.kind == Kind::uniform ? transition.takes.b : transition.takes.a);
  }
  return std::max(longest, unit.rest == to ? unit.travel : 0);
}

std::uint32_t Observer::Impl::timed_by(const Unit& unit, const Move& move) {
  if (move.transition != kNone || !move.spring_return) return move.transition;
  const auto found = std::find_if(unit.transitions.begin(), unit.transitions.end(), [&](const model::Transition& t) {
    return t.from == move.from && t.to == move.to && (t.on != kNone || t.spring_return);
  });
  return found == unit.transitions.end() ? kNone : static_cast<std::uint32_t>(found - unit.transitions.begin());
}

bool Observer::Impl::may_be_stopped(std::uint32_t u) const {
  for (const auto& [other, state] : disabled_by_[u]) {
    if (!view_.settled(other, state)) return true;
  }
  const Move& move = units_[u].next;
  const std::uint32_t timed = timed_by(plant_.units[u], move);
  if (timed == kNone) return false;
  const std::uint32_t during = plant_.units[u].transitions[timed].during;
  return during != kNone && !holds(plant_.units[u].conditions[during], view_);
}

std::uint32_t Observer::Impl::passes_to(std::uint32_t u, std::uint32_t state) {
  own_ = u;
  own_state_ = state;
  const std::uint32_t next = units_[u].causes.passes_to(plant_.units[u], state, view_, grace_ / 2);
  own_ = kNone;
  return next;
}

bool Observer::Impl::may_have_passed(std::uint32_t u) {
  Followed& followed = units_[u];
  const std::uint32_t next = passes_to(u, followed.next.to);
  if (next != kNone) {
    const bool shows =
        followed.moving && followed.positions.is_lit(next) && plant_.units[u].actuation == tables::Actuation::latched;
    if (!shows || (followed.passed_to != kNone && followed.passed_to != next)) return true;
    followed.passed_to = next;
  }
  return followed.passed_to != kNone && passes_to(u, followed.passed_to) != kNone;
}

bool Observer::Impl::is_disabled(std::uint32_t u) const {
  return std::any_of(disabled_by_[u].begin(), disabled_by_[u].end(),
                     [&](const auto& by) { return view_.settled(by.first, by.second) == true; });
}

bool Observer::Impl::is_stopped(std::uint32_t u) const {
  const Move& move = units_[u].next;
  if (is_disabled(u)) return true;
  const Unit& unit = plant_.units[u];
  const std::uint32_t timed = timed_by(unit, move);
  if (timed == kNone) return false;
  const model::Transition& transition = unit.transitions[timed];
  if (transition.during != kNone && holds(unit.conditions[transition.during], view_) == false) return true;
  return unit.actuation == tables::Actuation::held && move.transition != kNone && transition.on != kNone &&
         !units_[u].causes.commands(unit, move.from, move.to);
}

bool Observer::Impl::lacks_command_only(std::uint32_t u) const {
  const Unit& unit = plant_.units[u];
  const std::uint32_t timed = timed_by(unit, units_[u].next);
  return unit.actuation == tables::Actuation::held && timed != kNone && unit.transitions[timed].during == kNone &&
         !is_disabled(u);
}

bool Observer::Impl::is_halted_unseen(std::uint32_t u) const {
  const Followed& followed = units_[u];
  const Unit& unit = plant_.units[u];
  if (followed.moving || followed.came_from == kNone) return false;
  if (unit.actuation == tables::Actuation::held && followed.came_by_command) {
    return !followed.causes.commands(unit, followed.came_from, followed.state);
  }
  return unit.actuation != tables::Actuation::latched &&
         followed.causes.commands(unit, followed.state, followed.came_from);
}

bool Observer::Impl::is_ambiguous(std::uint32_t u, const Cause& cause) const {
  const Followed& followed = units_[u];
  if (!cause.is_certain()) return false;
  const Unit& unit = plant_.units[u];
  const bool at_once = cause.transition == kNone || unit.transitions[cause.transition].after.is_zero();
  const bool shows_leaving = followed.positions.is_lit(followed.state);
  const bool prompt = at_once && shows_leaving && now_ - cause.since <= grace_;
  return followed.causes.has_rival(unit, cause, !followed.positions.is_lit(cause.to), prompt, grace_ / 2);
}

bool Observer::Impl::may_not_have_rested(std::uint32_t u, Time arrived) const {
  const Followed& followed = units_[u];
  if (followed.next.cause == kUnknown || followed.next.from == kNone) return false;
  if (followed.unsure) return true;
  if (followed.at_once || followed.rests_since == kUnknown) return false;
  const Time took = arrived - followed.next.cause;
  if (took == 0 && grace_ == 0) return true;  // it turned back before it had moved
  const Time travel = longest_travel(plant_.units[u], followed.state);
  return followed.next.cause - followed.rests_since < std::max(kRestShare * took, travel);
}

}  // namespace symplant::observe
