// Compares what units do with what their model expects.
#include "watch/watcher.hpp"

#include <algorithm>
#include <utility>

namespace symplant::watch {

using observe::Move;
using observe::Step;
using observe::View;

/// This number of moves in a row that do not arrive is no chance, though each alone may be.
constexpr std::size_t kFailedInARow = 3;

Watcher::Watcher(const model::PlantModel& plant, const std::vector<bool>& recorded, const observe::Observer& observer,
                 const Margin& margin, const std::vector<Statistic>& learned, Report report)
    : plant_(plant),
      recorded_(recorded),
      observer_(observer),
      margin_(margin),
      report_(std::move(report)),
      possible_(plant, recorded, observer, margin, learned),
      units_(plant.units.size()),
      timers_(plant.units.size()),
      drift_(plant, learned, margin.resolution) {
  counts_.of_unit.resize(plant.units.size());
}

void Watcher::time(Time now) {
  timers_.run(now, [this](const Timer& timer) { fire(timer); });
}

void Watcher::command(Time now, std::uint32_t symbol, bool on) {
  const std::uint32_t u = plant_.symbols[symbol].unit;
  if (u == kNone) return;
  Watched& watched = units_[u];
  watched.commanded = now;
  if (watched.is_loose() && possible_.is_cause(watched.loose, symbol, on)) forget_loose(u);  // read after its effect
  const View view = observer_.view(u);
  if (view.moving) {
    const tables::Actuation actuation = plant_.units[u].actuation;
    if (on || actuation == tables::Actuation::spring) {
      turns(now, view);
    } else if (actuation == tables::Actuation::held && !view.stopped && view.next.is_caused()) {
      await_failed(now, view.next, now - view.next.cause - view.next.stopped);
    }
  }
  if (!on || view.state != kNone || view.contradicts || watched.reported || timers_.is_set(u, Timer::Kind::dark))
    return;
  const model::Unit& unit = plant_.units[u];
  const Time longest = unit.has_behaviour() ? kUnknown : longest_move(unit);
  if (longest == kUnknown || !possible_.shows_all(unit)) return;
  timers_.set(u, Timer::Kind::dark, now + longest + margin_.of(longest));
}

void Watcher::step(Time now, const Step& step) {
  const std::uint32_t u = step.move.unit;
  units_[u].stepped = now;
  switch (step.kind) {
    case Step::Kind::caused:
      return caused(step.move);
    case Step::Kind::canceled:
      return canceled(now, step.move);
    case Step::Kind::left:
      return left(now, step.move);
    case Step::Kind::arrived:
      return arrived(now, step.move);
    case Step::Kind::contradiction:
      return contradicts(now, step.move);
    case Step::Kind::settled:
      units_[u].contradicts = kUnknown;
      units_[u].reported = false;
      units_[u].open = 0;
      return timers_.cancel(u, Timer::Kind::contradiction);
  }
}

void Watcher::gap(Time now, Time length) {
  timers_.cancel_all();
  std::fill(units_.begin(), units_.end(), Watched{});
  if (length <= 0 || length < 3 * margin_.resolution) return;
  Anomaly anomaly;
  anomaly.kind = Kind::silent;
  anomaly.time = now;
  anomaly.took = length;
  report(std::move(anomaly), false);
}

void Watcher::caused(const Move& move) {
  Watched& watched = units_[move.unit];
  if (watched.contradicts != kUnknown) return;
  watched.expected = move;
  watched.canceled = {};
  watched.reported = false;
  watched.open = 0;
  wait_for(move);
}

void Watcher::canceled(Time now, const Move& move) {
  Watched& watched = units_[move.unit];
  if (watched.contradicts != kUnknown) return;
  timers_.cancel(move.unit, Timer::Kind::missing);
  watched.canceled = move;
  const View view = observer_.view(move.unit);
  if (move.turned || view.stopped || view.state != move.from) return;
  await_failed(now, move, now - move.cause - move.stopped);
}

bool Watcher::is_shown(const Move& move) const {
  const model::Unit& unit = plant_.units[move.unit];
  return possible_.shows(unit, move.from) || possible_.shows(unit, move.to);
}

void Watcher::wait_for(const Move& move) {
  const Limits limits = possible_.limits(move);
  if (!limits.known || !move.is_caused() || !is_shown(move)) return timers_.cancel(move.unit, Timer::Kind::missing);
  timers_.set(move.unit, Timer::Kind::missing, move.cause + margin_.missing_after(limits.total().most) + move.stopped);
}

void Watcher::left(Time now, const Move& move) {
  end_failed(now, move);
  Watched& watched = units_[move.unit];
  const bool complete = move.to != kNone && !possible_.shows(plant_.units[move.unit], move.to);
  if (complete) {
    ++counts_.of_unit[move.unit];
    failed_.erase({move.unit, move.to});
  }
  if (!move.is_caused()) {
    timers_.cancel(move.unit, Timer::Kind::missing);
    if (!possible_.may_have_cause(move, watched.canceled)) await_cause(now, move);
    return;
  }
  watched.expected = move;
  if (complete || possible_.limits(move).after.most > 0) judge(Part::leaving, now, move);
  if (!complete) return wait_for(move);
  timers_.cancel(move.unit, Timer::Kind::missing);
  watched.open = 0;
}

void Watcher::arrived(Time now, const Move& move) {
  end_failed(now, move);
  failed_.erase({move.unit, move.to});
  Watched& watched = units_[move.unit];
  timers_.cancel(move.unit, Timer::Kind::missing);
  if (move.from != kNone) {
    ++counts_.of_unit[move.unit];
    if (move.from != move.to && move.turned && watched.expected.to != move.to) judge_return(now, move);
    const bool was_loose = watched.is_loose() && watched.loose.left == move.left;
    if (!move.is_caused()) {
      came_without_cause(now, move);
    } else if (was_loose) {
      forget_loose(move.unit);
    } else if (move.from == move.to) {
      judge_return(now, move);
    } else if (!move.turned) {
      judge(Part::arriving, now, move);
    }
  }
  watched.expected = {};
  watched.canceled = {};
  watched.contradicts = kUnknown;
  watched.turned = kUnknown;
  watched.reported = false;
  watched.open = 0;
}

void Watcher::contradicts(Time now, const Move& move) {
  Watched& watched = units_[move.unit];
  forget_loose(move.unit);
  watched.failed_net = kUnknown;
  watched.contradicts = now;
  watched.expected = move;
  timers_.set(move.unit, Timer::Kind::contradiction, now + 2 * margin_.resolution);
}

/// A change was read that has no cause; its cause may be read in the next image.
void Watcher::await_cause(Time now, const Move& move) {
  Watched& watched = units_[move.unit];
  if (watched.is_loose()) fire_unexpected(move.unit);
  watched.loose = move;
  watched.loose_since = now;
  timers_.set(move.unit, Timer::Kind::unexpected, now + 2 * margin_.resolution);
}

void Watcher::forget_loose(std::uint32_t unit) {
  units_[unit].loose_since = kUnknown;
  timers_.cancel(unit, Timer::Kind::unexpected);
}

void Watcher::came_without_cause(Time now, const Move& move) {
  Watched& watched = units_[move.unit];
  if (watched.is_loose() && watched.loose.left == move.left) {
    watched.loose = move;
    return;
  }
  const bool known = watched.reported || move.from == move.to || possible_.may_have_cause(move, watched.canceled);
  if (!known && !possible_.hides_cause(move)) await_cause(now, move);
}

void Watcher::fire(const Timer& timer) {
  switch (timer.kind) {
    case Timer::Kind::missing:
      return fire_missing(timer);
    case Timer::Kind::unexpected:
      return fire_unexpected(timer.unit);
    case Timer::Kind::contradiction:
      return fire_contradiction(timer);
    case Timer::Kind::dark:
      return fire_dark(timer);
    case Timer::Kind::failed:
      return fire_failed(timer.due, timer.unit);
  }
}

void Watcher::fire_unexpected(std::uint32_t unit) {
  const Watched& watched = units_[unit];
  const Move move = watched.loose;
  const Time since = watched.loose_since;
  forget_loose(unit);
  // What its condition reads, or what enabled it, may have been read a little later.
  const std::vector<std::uint32_t>& causes = possible_.causes_of(unit);
  const bool follows =
      std::any_of(causes.begin(), causes.end(), [&](std::uint32_t other) { return units_[other].stepped >= since; });
  if (follows || possible_.hides_cause(move)) return;
  const bool came = move.to != kNone && move.to != move.from;
  const View view = observer_.view(unit);
  report(about(Kind::unexpected, came ? Part::arriving : Part::leaving, since, move),
         view.moving && view.next.left == move.left);
}

void Watcher::fire_missing(const Timer& timer) {
  const Watched& watched = units_[timer.unit];
  const View view = observer_.view(timer.unit);
  const Move& move = view.next;
  const Limits limits = possible_.limits(move);
  if (move.to == kNone || !move.is_caused() || move.cause != watched.expected.cause || !limits.known ||
      watched.reported) {
    return;
  }
  const Time wait = margin_.missing_after(limits.total().most) + (view.moving ? possible_.longer_by(move) : 0);
  const Time begin = move.turned ? std::max(move.cause, watched.commanded) : move.cause;
  const Time due = view.stopped ? timer.due + std::max<Time>(wait, 1) : begin + wait + move.stopped;
  if (due > timer.due) return timers_.set(timer.unit, Timer::Kind::missing, due);
  if (possible_.may_be_stopped(move)) return;
  const bool leaves = !view.moving && possible_.shows(plant_.units[timer.unit], move.from);
  Anomaly anomaly = about(Kind::missing, leaves ? Part::leaving : Part::arriving, timer.due, move);
  anomaly.took = timer.due - move.cause - move.stopped;
  anomaly.allowed = limits.total();
  anomaly.margin = margin_.of(limits.total().most);
  anomaly.failed = ++failed_[{move.unit, move.to}];
  report(std::move(anomaly), true);
}

void Watcher::fire_contradiction(const Timer& timer) {
  const Watched& watched = units_[timer.unit];
  const model::Unit& unit = plant_.units[timer.unit];
  Anomaly anomaly = about(Kind::contradiction, Part::arriving, watched.contradicts, watched.expected);
  for (const model::State& state : unit.states) {
    if (state.event != kNone && is_on(unit.events[state.event])) anomaly.on.push_back(unit.events[state.event]);
  }
  report(std::move(anomaly), true);
}

void Watcher::fire_dark(const Timer& timer) {
  const model::Unit& unit = plant_.units[timer.unit];
  const View view = observer_.view(timer.unit);
  if (view.state != kNone || view.contradicts) return;
  Move move;
  move.unit = timer.unit;
  move.cause = units_[timer.unit].commanded;
  Anomaly anomaly = about(Kind::contradiction, Part::arriving, timer.due, move);
  for (const std::uint32_t symbol : unit.operations) {
    if (recorded_[symbol] && is_on(symbol)) anomaly.symbols.push_back(symbol);
  }
  if (anomaly.symbols.empty()) return;
  anomaly.took = timer.due - move.cause;
  report(std::move(anomaly), true);
}

void Watcher::judge(Part part, Time now, const Move& move) {
  const Limits limits = possible_.limits(move);
  if (!limits.known || units_[move.unit].reported) return;
  const Range allowed = part == Part::leaving ? limits.after : limits.total();
  const Time end = part == Part::leaving ? move.left : move.arrived;
  if (part == Part::arriving) ++counts_.judged;
  const Time took = end - move.cause - move.stopped;
  const Time margin = margin_.of(limits.total().most);
  // A held device that arrives long after its command ended did so before: its event came late.
  const bool halted = part == Part::arriving && took >= allowed.least - margin;
  const bool late = took + (halted ? move.halted : 0) > allowed.most + margin;
  if (!late && took >= allowed.least - margin) {
    if (move.stopped == 0) look_for_drift(now, move);
    return;
  }
  if (late ? possible_.may_be_stopped(move) : possible_.may_begin_midway(move)) return;
  Anomaly anomaly = about(late ? Kind::late : Kind::early, part, now, move);
  anomaly.took = late && halted ? took + move.halted : took;
  anomaly.allowed = allowed;
  anomaly.margin = margin;
  report(std::move(anomaly), false);
}

/// By how much a move began late: that is another anomaly than its arrival.
Time Watcher::late_by(const Move& move, const Limits& limits) {
  return move.left == kUnknown ? 0 : std::max<Time>(move.left - move.cause - limits.after.most, 0);
}

/// Whether it should have arrived before it was commanded back, or on.
void Watcher::judge_return(Time now, const Move& move) {
  const Watched& watched = units_[move.unit];
  const Move& expected = watched.expected;
  if (watched.turned == kUnknown || expected.from != move.from || expected.to == kNone) return;
  // It may have moved elsewhere from the beginning.
  const std::vector<model::Transition>& all = plant_.units[move.unit].transitions;
  const bool may_go = std::any_of(all.begin(), all.end(), [&](const model::Transition& other) {
    return other.on == kNone && other.from == move.from && other.to == move.to;
  });
  if (may_go) return;
  const Limits limits = possible_.limits(expected);
  const Range total = limits.total();
  const Time net = watched.turned_net - late_by(expected, limits);
  // An arrival just before it was turned may lie between two readings.
  const Time seen = 2 * margin_.resolution;
  const bool in_time = net >= total.least && (margin_.resolution == 0 || watched.turned_idle >= seen);
  did_not_arrive(now, expected, Part::arriving, watched.turned_net, in_time || net >= total.most + seen);
}

/// It is commanded elsewhere while it moves.
void Watcher::turns(Time now, const View& view) {
  Watched& watched = units_[view.next.unit];
  if (watched.turned != kUnknown || !view.next.is_caused()) return;
  watched.turned = now;
  watched.turned_idle = view.stopped ? now - std::max(view.stopped_since, view.next.cause) : 0;
  watched.turned_net = now - view.next.cause - view.next.stopped - watched.turned_idle;
}

/// The command of a move ended after the unit was let move for `net`. What came of it may be read a little later.
void Watcher::await_failed(Time now, const Move& move, Time net) {
  Watched& watched = units_[move.unit];
  if (watched.reported || move.to == kNone) return;
  watched.failed = move;
  watched.failed_net = net;
  timers_.set(move.unit, Timer::Kind::failed, now + 2 * margin_.resolution);
}

/// A move has begun or ended: the one whose command ended was another one, or is this one.
void Watcher::end_failed(Time now, const Move& move) {
  Watched& watched = units_[move.unit];
  const bool other = move.is_caused() && move.cause != watched.failed.cause;
  if (watched.failed_net != kUnknown && other) fire_failed(now, move.unit);
  watched.failed_net = kUnknown;
}

void Watcher::fire_failed(Time now, std::uint32_t unit) {
  Watched& watched = units_[unit];
  const Time net = std::exchange(watched.failed_net, kUnknown);
  if (net == kUnknown || observer_.view(unit).state != watched.failed.from) return;
  const Move move = watched.failed;
  const Limits limits = possible_.limits(move);
  const Range total = limits.total();
  const Time seen = 3 * margin_.resolution;
  if (move.left != kUnknown) return did_not_arrive(now, move, Part::arriving, net, false);
  if (possible_.shows(plant_.units[unit], move.from)) {
    // Between two readings it may have gone and come back.
    if (limits.takes.most <= 2 * margin_.resolution && possible_.longer_by(move) > 0) return;
    return did_not_arrive(now, move, Part::leaving, net, net >= std::max(total.least, seen));
  }
  did_not_arrive(now, move, Part::arriving, net, net >= (seen == 0 ? total.least : total.most + seen));
}

/// It was let move for `net`, and did not leave or arrive. `counts`: alone this is no anomaly, but in a row.
void Watcher::did_not_arrive(Time now, const Move& move, Part part, Time net, bool counts) {
  const Limits limits = possible_.limits(move);
  if (units_[move.unit].reported || !move.is_caused() || !limits.known || !is_shown(move)) return;
  if (possible_.may_be_stopped(move)) return;
  const Time most = limits.total().most;
  // Learned times of leaving and arriving may be those of the whole move: all of it counts from when it left.
  const Time before = move.left == kUnknown ? 0 : move.left - move.cause;
  const bool is_sure = net - before > most + margin_.of(most) + 2 * margin_.resolution;
  if (!is_sure && !counts) return;
  const std::size_t failed = ++failed_[{move.unit, move.to}];
  if (!is_sure && failed < kFailedInARow) return;
  Anomaly anomaly = about(Kind::missing, part, now, move);
  anomaly.took = net;
  anomaly.allowed = limits.total();
  anomaly.margin = margin_.of(most);
  anomaly.failed = failed;
  report(std::move(anomaly), false);
}

void Watcher::look_for_drift(Time now, const Move& move) {
  const Limits limits = possible_.limits(move);
  const auto add = [&](Span span, Time begin, Time end, const Range& allowed) {
    if (begin == kUnknown || end == kUnknown) return;
    const auto found = drift_.add(move, span, end - begin);
    if (!found) return;
    Anomaly anomaly = about(Kind::drift, span == Span::after ? Part::leaving : Part::arriving, now, move);
    anomaly.took = static_cast<Time>(found->mean);
    anomaly.learned = static_cast<Time>(found->learned->mean);
    anomaly.learned_moves = found->learned->n;
    anomaly.allowed = allowed;
    report(std::move(anomaly), false);
  };
  if (move.arrived == kUnknown) return add(Span::after, move.cause, move.left, limits.after);
  add(Span::takes, move.left, move.arrived, limits.takes);
  add(Span::total, move.cause, move.arrived, limits.total());
  if (limits.after.most == 0) add(Span::after, move.cause, move.left, limits.after);  // else judged when it left
}

Anomaly Watcher::about(Kind kind, Part part, Time now, const Move& move) const {
  const model::Unit& unit = plant_.units[move.unit];
  Anomaly anomaly;
  anomaly.kind = kind;
  anomaly.part = part;
  anomaly.time = now;
  anomaly.unit = move.unit;
  anomaly.move = move;
  if (move.transition != kNone && unit.transitions[move.transition].on != kNone) {
    anomaly.symbols.push_back(unit.operations[unit.transitions[move.transition].on]);
  }
  for (const std::uint32_t state : {move.from, move.to}) {
    if (state == kNone || unit.states[state].event == kNone) continue;
    const std::uint32_t symbol = unit.events[unit.states[state].event];
    if (std::find(anomaly.symbols.begin(), anomaly.symbols.end(), symbol) == anomaly.symbols.end()) {
      anomaly.symbols.push_back(symbol);
    }
  }
  return anomaly;
}

bool Watcher::is_on(std::uint32_t symbol) const {
  return (observer_.value(symbol) != 0) != plant_.symbols[symbol].inverted;
}

/// The anomaly that one of this unit follows from; 0: none.
std::size_t Watcher::first_of(std::uint32_t unit) const {
  if (units_[unit].open != 0) return units_[unit].open;
  for (const std::uint32_t other : possible_.causes_of(unit)) {
    if (units_[other].open != 0) return units_[other].open;
  }
  return 0;
}

/// `stays`: from now on the unit is not where it should be.
void Watcher::report(Anomaly anomaly, bool stays) {
  anomaly.number = ++numbers_;
  if (anomaly.unit != kNone && anomaly.kind != Kind::drift) {
    Watched& watched = units_[anomaly.unit];
    anomaly.follows = first_of(anomaly.unit);
    if (stays) watched.open = anomaly.is_first() ? anomaly.number : anomaly.follows;
    // A change without a cause may be over.
    if (stays || anomaly.kind != Kind::unexpected) watched.reported = true;
  }
  report_(anomaly);
}

}  // namespace symplant::watch
