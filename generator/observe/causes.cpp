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
  conflicts_ = false;
  conflicted_ = -1;
  pending_ = {};
  ended_ = {};
}

void Causes::update(const model::Unit& unit, Levels levels, const Known& known, Time time, bool may_begin, bool shown) {
  level_ = levels.on;
  doubtful_ &= level_;
  known_ = levels.known & ~doubtful_;
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
  Cause next = choose(unit, time);
  if (may_begin && is_committed(unit, time, shown) &&
      (next.to == kNone || unit.actuation == tables::Actuation::latched))
    next = pending_;
  if (pending_.is_certain() && !(next == pending_)) {
    ended_ = pending_;
    ended_at_ = time;
  }
  pending_ = next;
}

bool Causes::is_committed(const model::Unit& unit, Time time, bool shown) const {
  if (!pending_.is_certain() || pending_.transition == kNone) return false;
  const Transition& transition = unit.transitions[pending_.transition];
  if (shown && !transition.after.is_zero()) return false;  // it has not left, whatever time the model has
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
  bool is_known = true;
  for (std::uint32_t o = 0; springs && o < unit.operations.size(); ++o) {
    if (((known_ & bit_of(o)) != 0 && (on_ & bit_of(o)) == 0) || !leads_to(unit, o, state_)) continue;
    ((known_ & bit_of(o)) != 0 ? wanted : is_known) = (known_ & bit_of(o)) != 0;
  }
  quiet_ = wanted ? kHoldsNot : !is_known ? -1 : quiet_ == kHoldsNot ? time : quiet_;
}

Cause Causes::automatic(const model::Unit& unit) const {
  Cause first;
  Time first_ready = kHoldsNot;
  for (std::uint32_t i = 0; i < unit.transitions.size(); ++i) {
    const Transition& transition = unit.transitions[i];
    if (transition.from != state_ || transition.on != kNone || since_[i] < 0 || since_[i] == kHoldsNot) continue;
    const Time at = ready(transition, since_[i]);
    if (at >= first_ready) continue;
    first = {transition.to, i, since_[i]};
    first_ready = at;
  }
  return first;
}

Causes::Commanded Causes::commanded(const model::Unit& unit, Time time) const {
  Commanded best;
  best.ready = kHoldsNot;
  const auto holds = [&](std::uint32_t i) {
    const Transition& transition = unit.transitions[i];
    return transition.from == state_ && transition.on != kNone && since_[i] >= 0 && since_[i] != kHoldsNot;
  };
  for (std::uint32_t i = 0; i < unit.transitions.size(); ++i) {
    const Time at = holds(i) ? ready(unit.transitions[i], since_[i]) : kHoldsNot;
    if (at >= best.ready) continue;
    best.cause = {unit.transitions[i].to, i, since_[i]};
    best.ready = at;
  }
  if (best.cause.to == kNone) return best;
  std::uint64_t used = 0;
  for (std::uint32_t i = 0; i < unit.transitions.size(); ++i) {
    if (!holds(i) || ready(unit.transitions[i], since_[i]) > std::max(best.ready, time)) continue;
    used |= bit_of(unit.transitions[i].on);
    best.conflicts = best.conflicts || unit.transitions[i].to != best.cause.to;
  }
  for (std::uint32_t o = 0; o < unit.operations.size(); ++o) {
    if ((on_ & ~used & bit_of(o)) != 0 && leads_to(unit, o, state_)) best.conflicts = true;
  }
  return best;
}

Cause Causes::choose(const model::Unit& unit, Time time) {
  const Cause first = automatic(unit);
  Commanded command = commanded(unit, time);
  if (conflicts_ && !command.conflicts) conflicted_ = time;
  conflicts_ = command.conflicts;
  if (command.cause.to != kNone && command.cause.since < conflicted_) {
    // It could leave when the conflict was over; how long the cause had held then is not certain.
    const bool at_once = unit.transitions[command.cause.transition].after.is_zero();
    command.cause.since = at_once ? conflicted_ : -1;
    command.ready = std::max(command.ready, conflicted_);
  }
  const Time quiet = quiet_ == kHoldsNot || quiet_ < 0 ? quiet_ : std::max(quiet_, conflicted_);
  if (!conflicts_ && quiet >= 0 && quiet < command.ready) {  // without a command it returns at once
    command.cause = {unit.rest, kNone, quiet};
    command.ready = quiet;
  }
  const Time automatic_ready = first.to == kNone ? kHoldsNot : ready(unit.transitions[first.transition], first.since);
  if (first.to != kNone && (automatic_ready <= command.ready || conflicts_)) return first;
  return conflicts_ ? Cause{} : command.cause;
}

Cause Causes::of(const model::Unit& unit, std::uint32_t to, Time now, Time grace) const {
  const auto fits = [to](const Cause& cause) { return cause.to != kNone && (to == kNone || cause.to == to); };
  if (fits(pending_)) return pending_;
  for (std::uint32_t i = 0; i < unit.transitions.size(); ++i) {
    const bool clear = since_[i] >= conflicted_ && !conflicts_;
    const Cause cause{unit.transitions[i].to, i, clear ? since_[i] : -1};
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

void Causes::doubt(const model::Unit& unit) {
  if (unit.actuation != tables::Actuation::latched) return;
  const bool disarms = std::any_of(unit.transitions.begin(), unit.transitions.end(),
                                   [](const Transition& t) { return t.on == kNone || t.once; });
  if (disarms) doubtful_ |= level_ & ~disarmed_;
}

bool Causes::commands(const model::Unit& unit, std::uint32_t from, std::uint32_t to) const {
  return std::any_of(unit.transitions.begin(), unit.transitions.end(), [&](const Transition& t) {
    return t.on != kNone && t.from == from && t.to == to && (on_ & bit_of(t.on)) != 0;
  });
}

bool Causes::has_rival(const model::Unit& unit, const Cause& cause, bool to_any, bool prompt, Time resolution) const {
  const auto goes_on = [&](std::uint32_t from) {
    return std::any_of(unit.transitions.begin(), unit.transitions.end(), [&](const Transition& t) {
      return t.from == from && t.to == cause.to && !t.spring_return && ready(t, 0) <= resolution;
    });
  };
  for (std::uint32_t i = 0; i < unit.transitions.size(); ++i) {
    const Transition& transition = unit.transitions[i];
    if (transition.from != state_ || i == cause.transition || since_[i] == kHoldsNot) continue;
    if (prompt && ready(transition, 0) > resolution) continue;
    if (to_any || transition.to == cause.to || goes_on(transition.to)) return true;
  }
  // A return takes the time of the command to the same state.
  return !prompt && cause.transition != kNone && quiet_ != kHoldsNot && (to_any || unit.rest == cause.to);
}

std::uint32_t Causes::passes_to(const model::Unit& unit, std::uint32_t state, const Known& known,
                                Time resolution) const {
  for (const Transition& transition : unit.transitions) {
    if (transition.from != state || transition.spring_return || ready(transition, 0) > resolution) continue;
    if (transition.on != kNone && (on_ & bit_of(transition.on)) == 0) continue;
    if (cause_holds(unit, transition, on_, known_, known) != false) return transition.to;
  }
  return kNone;
}

}  // namespace symplant::observe
