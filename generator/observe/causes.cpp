// What makes a unit leave its state.
#include "observe/causes.hpp"

#include <algorithm>
#include <optional>

namespace symplant::observe {
namespace {

using model::kNone;
using model::Transition;
using tables::Time;

constexpr Time kHoldsNot = tables::kNever;

std::uint64_t bit_of(std::uint32_t index) { return std::uint64_t{1} << index; }

/// The earliest time at which a cause that began at `since` can make its unit leave.
Time ready(const Transition& transition, Time since) {
  const bool bounded = transition.after.kind == description::Duration::Kind::fixed ||
                       transition.after.kind == description::Duration::Kind::uniform;
  return since + (bounded ? transition.after.a : 0);
}

std::optional<bool> cause_holds(const model::Unit& unit, const Transition& transition, std::uint64_t on,
                                std::uint64_t known_operations, const Known& known) {
  const bool is_known = transition.on == kNone || (known_operations & bit_of(transition.on)) != 0;
  if (is_known && transition.on != kNone && (on & bit_of(transition.on)) == 0) return false;
  const auto when = transition.when == kNone ? std::optional(true) : holds(unit.conditions[transition.when], known);
  return is_known || when == false ? when : std::nullopt;
}

}  // namespace

void Causes::enter(const model::Unit& unit, std::uint32_t state, Time time) {
  since_.assign(unit.transitions.size(), kHoldsNot);
  state_ = state;
  entered_ = time;
  fresh_ = true;
  quiet_ = kHoldsNot;
  pending_ = {};
  ended_ = {};
}

void Causes::update(const model::Unit& unit, Levels levels, const Known& known, Time time) {
  level_ = levels.on;
  known_ = levels.known;
  disarmed_ &= level_;
  on_ = level_ & ~disarmed_;
  if (state_ == kNone) return;
  const Time began = fresh_ ? entered_ : time;
  for (std::size_t i = 0; i < unit.transitions.size(); ++i) {
    const Transition& transition = unit.transitions[i];
    if (transition.from != state_ || transition.spring_return) continue;
    const std::optional<bool> now = cause_holds(unit, transition, on_, known_, known);
    if (now == false) {
      since_[i] = kHoldsNot;
    } else if (!now) {
      since_[i] = -1;
    } else if (since_[i] == kHoldsNot) {
      since_[i] = began;
    }
  }
  update_quiet(unit, began);
  fresh_ = false;
  Cause next = choose(unit);
  if (is_committed(unit, time) && (next.to == kNone || unit.actuation == tables::Actuation::latched)) next = pending_;
  if (pending_.is_certain() && !(next == pending_)) {
    ended_ = pending_;
    ended_at_ = time;
  }
  pending_ = next;
}

bool Causes::is_committed(const model::Unit& unit, Time time) const {
  if (!pending_.is_certain() || pending_.transition == kNone) return false;
  const Transition& transition = unit.transitions[pending_.transition];
  const bool completes = transition.on == kNone || unit.actuation == tables::Actuation::latched ||
                         unit.actuation == tables::Actuation::bistable;
  return completes && ready(transition, pending_.since) < time;
}

bool Causes::leads_to(const model::Unit& unit, std::uint32_t operation, std::uint32_t state) const {
  if (unit.states[state].operation == operation) return true;
  return std::any_of(unit.transitions.begin(), unit.transitions.end(),
                     [&](const Transition& t) { return t.on == operation && t.to == state; });
}

void Causes::update_quiet(const model::Unit& unit, Time time) {
  const bool springs = unit.actuation == tables::Actuation::spring && unit.rest != state_ && unit.rest != kNone;
  bool wanted = !springs;
  for (std::uint32_t o = 0; springs && o < unit.operations.size(); ++o) {
    if ((known_ & bit_of(o)) != 0 && (on_ & bit_of(o)) == 0) continue;
    const bool leaves = std::any_of(unit.transitions.begin(), unit.transitions.end(),
                                    [&](const Transition& t) { return t.on == o && t.from == state_; });
    wanted = wanted || leaves || leads_to(unit, o, state_);
  }
  quiet_ = wanted ? kHoldsNot : quiet_ == kHoldsNot ? time : quiet_;
}

Cause Causes::choose(const model::Unit& unit) const {
  Cause automatic;
  Cause commanded;
  Time automatic_ready = kHoldsNot;
  Time commanded_ready = kHoldsNot;
  std::uint64_t used = 0;
  bool conflict = false;
  for (std::uint32_t i = 0; i < unit.transitions.size(); ++i) {
    const Transition& transition = unit.transitions[i];
    if (transition.from != state_ || since_[i] < 0 || since_[i] == kHoldsNot) continue;
    const Time at = ready(transition, since_[i]);
    const Cause cause{transition.to, i, since_[i]};
    if (transition.on == kNone) {
      if (at < automatic_ready) {
        automatic = cause;
        automatic_ready = at;
      }
      continue;
    }
    used |= bit_of(transition.on);
    conflict = conflict || (commanded.to != kNone && commanded.to != transition.to);
    if (at < commanded_ready) {
      commanded = cause;
      commanded_ready = at;
    }
  }
  for (std::uint32_t o = 0; o < unit.operations.size(); ++o) {
    if ((on_ & ~used & bit_of(o)) != 0 && leads_to(unit, o, state_)) conflict = true;
  }
  if (automatic.to != kNone && (automatic_ready <= commanded_ready || conflict)) return automatic;
  if (commanded.to != kNone) return conflict ? Cause{} : commanded;
  if (automatic.to != kNone) return automatic;
  if (quiet_ >= 0 && quiet_ != kHoldsNot) return {unit.rest, kNone, quiet_};
  return {};
}

Cause Causes::of(const model::Unit& unit, std::uint32_t to, Time now, Time grace) const {
  const auto fits = [to](const Cause& cause) { return cause.to != kNone && (to == kNone || cause.to == to); };
  if (fits(pending_)) return pending_;
  for (std::uint32_t i = 0; i < unit.transitions.size(); ++i) {
    const Cause cause{unit.transitions[i].to, i, since_[i]};
    if (unit.transitions[i].from == state_ && since_[i] >= 0 && since_[i] != kHoldsNot && fits(cause)) return cause;
  }
  if (fits(ended_) && now - ended_at_ <= grace) return ended_;
  for (std::uint32_t i = 0; i < unit.transitions.size(); ++i) {
    const Cause cause{unit.transitions[i].to, i, -1};
    if (unit.transitions[i].from == state_ && since_[i] < 0 && fits(cause)) return cause;
  }
  const Cause spring{unit.rest, kNone, -1};
  return quiet_ < 0 && fits(spring) ? spring : Cause{};
}

void Causes::leave(const model::Unit& unit, const Cause& cause) {
  if (unit.actuation != tables::Actuation::latched || cause.transition == kNone) return;
  const Transition& transition = unit.transitions[cause.transition];
  if (transition.once && transition.on != kNone) disarmed_ |= level_ & bit_of(transition.on);
  if (transition.on != kNone) return;
  for (std::uint32_t o = 0; o < unit.operations.size(); ++o) {
    if ((level_ & bit_of(o)) != 0 && leads_to(unit, o, transition.from)) disarmed_ |= bit_of(o);
  }
}

bool Causes::commands(const model::Unit& unit, std::uint32_t from, std::uint32_t to) const {
  return std::any_of(unit.transitions.begin(), unit.transitions.end(), [&](const Transition& t) {
    return t.on != kNone && t.from == from && t.to == to && (on_ & bit_of(t.on)) != 0;
  });
}

}  // namespace symplant::observe
