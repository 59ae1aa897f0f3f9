// Causes, leaving and arrival of one unit.
#include <algorithm>
#include <utility>

#include "observe/observer_impl.hpp"

namespace symplant::observe {
namespace {

/// Of one unit within one time: more would be a fault of this code, not of the plant.
constexpr int kMostSteps = 64;

}  // namespace

void Observer::Impl::update_causes(std::uint32_t u) {
  Followed& followed = units_[u];
  const model::Unit& unit = plant_.units[u];
  // What moves it depends on how it was in its state, though its events may show already that it left.
  own_ = followed.moving ? kNone : u;
  own_state_ = followed.state;
  followed.causes.update(unit, levels(unit.operations), view_, now_, !is_disabled(u),
                         followed.state != kNone && followed.positions.is_lit(followed.state));
  own_ = kNone;
  if (followed.moving || followed.state == kNone) return;
  const auto is_other_dark = [&](std::uint32_t state) {
    return state != followed.state && !followed.positions.is_lit(state);
  };
  const bool is_dark = !followed.positions.is_lit(followed.state);
  if (is_dark && !followed.unsure && followed.causes.may_have_left_for(unit, is_other_dark)) {
    followed.unsure = true;
    queue_dependents(u);
  }
  const Cause cause = followed.causes.pending();
  const Cause before{followed.next.to, followed.next.transition, followed.next.cause};
  if (cause == before) return;
  if (before.to != kNone) {
    add(Step::Kind::canceled, followed.next);
    // It may have begun to move, which no event shows.
    if (before.since != now_ && !followed.positions.is_lit(followed.state)) followed.set_back = before;
  }
  followed.next = {};
  if (is_dark) queue_dependents(u);  // it is no longer certain that it is there
  if (cause.to == kNone) return;
  followed.next = move_of(u, cause);
  add(Step::Kind::caused, followed.next);
}

Move Observer::Impl::move_of(std::uint32_t u, const Cause& cause) const {
  Move move;
  move.unit = u;
  move.from = units_[u].state;
  move.to = cause.to;
  move.transition = cause.transition;
  move.spring_return = cause.is_spring_return();
  move.since = units_[u].since;
  move.cause = cause.since;
  return move;
}

void Observer::Impl::follow_move(std::uint32_t u) {
  Followed& followed = units_[u];
  const model::Unit& unit = plant_.units[u];
  if (std::exchange(followed.held_back, is_disabled(u) || may_be_stopped(u) || is_halted_unseen(u)) &&
      followed.rests_since != kUnknown) {
    followed.rests_since = now_;
  }
  const bool goes_on =
      followed.next.to != kNone && (followed.moving || !followed.positions.is_lit(followed.state) || is_disabled(u));
  const bool stopped = goes_on && is_stopped(u);
  if (followed.next.to != kNone && may_be_stopped(u)) followed.next.turned = true;
  const bool is_dark = !followed.moving && followed.state != kNone && !followed.positions.is_lit(followed.state);
  if (followed.next.to != kNone && (followed.moving || is_dark) && may_have_passed(u)) {
    followed.next.turned = true;
    followed.unsure = followed.unsure || is_dark;
  }
  if (followed.stopped_since != kUnknown && !stopped) {
    followed.next.stopped += now_ - std::max(followed.stopped_since, followed.next.cause);
    followed.stopped_since = kUnknown;
  } else if (followed.stopped_since == kUnknown && stopped) {
    followed.stopped_since = now_;
  }
  if (!followed.moving || followed.next.to == kNone || unit.actuation == tables::Actuation::latched) return;
  const bool back = followed.causes.commands(unit, followed.next.to, followed.next.from);
  const bool springs = unit.actuation == tables::Actuation::spring && followed.next.from == unit.rest &&
                       !followed.causes.commands(unit, followed.next.from, followed.next.to);
  const bool again = followed.next.spring_return && followed.causes.commands(unit, followed.next.to, followed.state);
  if (back || springs || again) followed.next.turned = true;
}

bool Observer::Impl::follow(std::uint32_t u, bool last_resort) {
  Followed& followed = units_[u];
  if (std::exchange(followed.visit, visit_) != visit_) followed.steps = 0;
  if (!followed.positions.shows_anything() || ++followed.steps > kMostSteps) return true;
  update_causes(u);
  const model::Unit& unit = plant_.units[u];
  const std::uint64_t events = levels(unit.events).on;
  const auto shown = followed.positions.at(events, followed.moving ? followed.next.to : followed.state);
  if (shown.shown == Positions::Shown::dark) clear_contradiction(u);
  if (shown.shown == Positions::Shown::unclear) {
    lose(u);
  } else if (shown.shown == Positions::Shown::contradiction) {
    contradict(u);
  } else if (followed.contradicts && shown.shown == Positions::Shown::state) {
    end_contradiction(u, shown.state);
  } else if (shown.shown == Positions::Shown::state && (followed.moving || shown.state != followed.state)) {
    if (!followed.moving && !last_resort && !cause_of(u, shown.state).is_certain()) return false;
    arrive(u, shown.state, now_);
  } else if (shown.shown == Positions::Shown::dark && !followed.moving && followed.state != kNone &&
             followed.positions.is_lit(followed.state) && !followed.positions.fits(followed.state, events)) {
    if (!last_resort && !cause_of(u, kNone).is_certain()) return false;
    leave(u);
  }
  follow_move(u);
  return true;
}

Cause Observer::Impl::cause_of(std::uint32_t u, std::uint32_t to) const {
  if (units_[u].state == kNone) return {};
  return units_[u].causes.of(plant_.units[u], to, now_, grace_);
}

void Observer::Impl::leave(std::uint32_t u) {
  Followed& followed = units_[u];
  const Cause cause = cause_of(u, kNone);
  begin_move(u, cause);
  followed.next.left = now_;
  if (followed.stopped_since != kUnknown) {
    followed.next.stopped += now_ - std::max(followed.stopped_since, followed.next.cause);
    followed.stopped_since = now_;
  }
  const bool hidden = cause.to != kNone ? !followed.positions.is_lit(cause.to) : dark_is_next(u);
  if (hidden) {
    if (cause.to == kNone) followed.next.to = followed.positions.dark_state();
    add(Step::Kind::left, followed.next);
    const bool at_once = cause.transition != kNone && plant_.units[u].transitions[cause.transition].takes.is_zero();
    const std::uint32_t from = followed.state;
    const bool unsure = cause.to != kNone && followed.causes.has_rival(plant_.units[u], cause, true, false, 0);
    settle(u, followed.next.to, now_);
    followed.unsure = unsure;
    followed.at_once = at_once;
    followed.came_from = from;
    followed.came_by_command = cause.transition != kNone && plant_.units[u].transitions[cause.transition].on != kNone;
    return;
  }
  add(Step::Kind::left, followed.next);
  followed.moving = true;
  followed.since = now_;
  queue_dependents(u);
}

void Observer::Impl::begin_move(std::uint32_t u, const Cause& cause) {
  Followed& followed = units_[u];
  const Cause before{followed.next.to, followed.next.transition, followed.next.cause};
  if (!(cause == before) || cause.to == kNone) {
    followed.next = move_of(u, cause);
    followed.stopped_since = kUnknown;
    followed.passed_to = kNone;
  }
  const Cause set_back = std::exchange(followed.set_back, {});
  if ((set_back.to != kNone && !(set_back == cause)) || followed.positions.misleads() || is_ambiguous(u, cause))
    followed.next.turned = true;
  followed.causes.leave(plant_.units[u], cause);
}

void Observer::Impl::arrive(std::uint32_t u, std::uint32_t state, Time time) {
  Followed& followed = units_[u];
  if (!followed.moving) {
    const Cause cause = cause_of(u, state);
    const bool shows_leaving = followed.state != kNone && followed.positions.is_lit(followed.state);
    begin_move(u, cause);
    if (shows_leaving) followed.next.left = time;
    if (!shows_leaving && may_not_have_rested(u, time)) followed.next.turned = true;
  } else if (followed.next.to != state) {
    take_other_end(u, state);
  }
  if (followed.stopped_since != kUnknown) {
    const Time stopped = now_ - std::max(followed.stopped_since, followed.next.cause);
    followed.next.stopped += stopped;
    if (lacks_command_only(u)) followed.next.halted = stopped;
  }
  followed.stopped_since = kUnknown;
  followed.next.to = state;
  followed.next.arrived = time;
  if (followed.next.cause > (followed.next.left != kUnknown ? followed.next.left : time) + grace_) {
    followed.next.cause = kUnknown;  // it began too late to be the cause
    followed.next.transition = kNone;
    followed.next.spring_return = false;
  }
  add(Step::Kind::arrived, followed.next);
  if (followed.next.turned || !followed.next.is_caused()) followed.causes.doubt(plant_.units[u]);
  settle(u, state, now_);
}

void Observer::Impl::take_other_end(std::uint32_t u, std::uint32_t state) {
  Move& move = units_[u].next;
  const bool came_back = state == move.from;
  const Cause cause = came_back ? Cause{} : cause_of(u, state);
  move.turned = move.turned || came_back || move.to != kNone;
  move.to = state;
  move.transition = cause.transition;
  move.spring_return = cause.is_spring_return();
  if (!came_back) move.cause = cause.since;
}

void Observer::Impl::settle(std::uint32_t u, std::uint32_t state, Time time) {
  Followed& followed = units_[u];
  followed.state = state;
  followed.moving = false;
  followed.contradicts = false;
  followed.unsure = false;
  followed.at_once = false;
  followed.came_from = kNone;
  followed.passed_to = kNone;
  followed.since = time;
  followed.rests_since = time;
  followed.held_back = false;
  followed.next = {};
  followed.causes.enter(plant_.units[u], state, time);
  queue(u);
  queue_dependents(u);
}

void Observer::Impl::lose(std::uint32_t u) {
  if (units_[u].state == kNone && !units_[u].moving) return;
  if (units_[u].next.to != kNone && !units_[u].moving) add(Step::Kind::canceled, units_[u].next);
  settle(u, kNone, kUnknown);
}

void Observer::Impl::contradict(std::uint32_t u) {
  Followed& followed = units_[u];
  if (followed.contradicts) return;
  followed.contradicts = true;
  followed.contradicts_since = now_;
  Move move = followed.next;
  move.unit = u;
  move.from = followed.state;
  add(Step::Kind::contradiction, move);
  queue_dependents(u);
}

void Observer::Impl::clear_contradiction(std::uint32_t u) {
  if (!std::exchange(units_[u].contradicts, false)) return;
  Move settled;
  settled.unit = u;
  settled.from = units_[u].state;
  add(Step::Kind::settled, settled);
  queue_dependents(u);
}

void Observer::Impl::end_contradiction(std::uint32_t u, std::uint32_t state) {
  Followed& followed = units_[u];
  followed.contradicts = false;
  Move settled;
  settled.unit = u;
  settled.from = followed.state;
  settled.to = state;
  add(Step::Kind::settled, settled);
  if (state == followed.state && !followed.moving) {
    queue_dependents(u);
    return;
  }
  if (!followed.moving) {
    begin_move(u, cause_of(u, state));
    followed.moving = true;  // the end that it left showed too long: no time of leaving
  }
  arrive(u, state, followed.contradicts_since);
}

}  // namespace symplant::observe
