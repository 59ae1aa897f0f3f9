// Whether moves have the times of the transitions that they are said to be.
#include "property/recordings/observed_moves.hpp"

#include <algorithm>
#include <cstdio>
#include <tuple>

namespace symplant::property {
namespace {

using observe::kNone;
using observe::kUnknown;
using observe::Move;
using tables::Time;

/// From the least to the most.
struct Span {
  Time least = 0;
  Time most = 0;

  bool holds(Time time, Time tolerance) const { return time >= least - tolerance && time <= most + tolerance; }
};

Span span_of(const description::Duration& duration) {
  return {duration.a, duration.kind == description::Duration::Kind::uniform ? duration.b : duration.a};
}

struct TimesOf {
  Span after;
  Span takes;

  Span both() const { return {after.least + takes.least, after.most + takes.most}; }
};

/// The times that a unit has for a return of its spring: of the first transition there, else the default.
TimesOf return_times(const model::Unit& unit, const Move& move) {
  const auto found = std::find_if(unit.transitions.begin(), unit.transitions.end(), [&](const model::Transition& t) {
    return t.from == move.from && t.to == move.to && (t.on != kNone || t.spring_return);
  });
  return {{}, found == unit.transitions.end() ? Span{unit.travel, unit.travel} : span_of(found->takes)};
}

TimesOf times_of(const model::Transition& transition) { return {span_of(transition.after), span_of(transition.takes)}; }

/// Empty if the move has its times.
std::string fault_of(const model::Unit& unit, const Move& move, Time tolerance) {
  const bool returns = move.transition == kNone;
  const TimesOf times = returns ? return_times(unit, move) : times_of(unit.transitions[move.transition]);
  if (!returns) {
    const model::Transition& transition = unit.transitions[move.transition];
    if (transition.from != move.from || transition.to != move.to) return "is another transition";
  }
  const bool shows_end = move.arrived != kUnknown;
  const Time whole = move.arrived - move.cause - move.stopped;
  if (shows_end && !times.both().holds(whole, move.stopped != 0 ? 2 * tolerance : tolerance))
    return "has another length";
  if (move.stopped != 0 || move.left == kUnknown) return {};
  if (!times.after.holds(move.left - move.cause, tolerance)) return "left at another time";
  return shows_end && !times.takes.holds(move.arrived - move.left, tolerance) ? "took another time" : "";
}

/// Moves by unit, states and end; of one whose end does not show the time of leaving counts.
using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, Time>;

}  // namespace

MoveCounts& MoveCounts::operator+=(const MoveCounts& other) {
  happened += other.happened;
  shown += other.shown;
  shown_seen += other.shown_seen;
  seen += other.seen;
  observed += other.observed;
  turned += other.turned;
  uncaused += other.uncaused;
  judged += other.judged;
  wrong += other.wrong;
  return *this;
}

std::string move_text(const model::PlantModel& plant, const Move& move) {
  const model::Unit& unit = plant.units[move.unit];
  const auto state = [&](std::uint32_t s) { return s == kNone ? std::string("?") : unit.states[s].name; };
  std::string text = std::string(unit.path) + ": " + state(move.from) + "->" + state(move.to);
  text += move.transition != kNone ? " #" + std::to_string(move.transition) : move.spring_return ? " spring" : " -";
  const auto add = [&](const char* name, Time time) {
    char number[40];
    std::snprintf(number, sizeof number, " %s %.6f", name, static_cast<double>(time) / 1e6);
    text += time == kUnknown ? std::string(" ") + name + " -" : number;
  };
  add("since", move.since);
  add("cause", move.cause);
  add("left", move.left);
  add("arrived", move.arrived);
  add("stopped", move.stopped);
  return text + (move.turned ? " turned" : "");
}

MoveCounts judge_moves(const model::PlantModel& real, const std::vector<Move>& observed,
                       const std::vector<TrueMove>& happened, tables::Time tolerance, std::vector<WrongMove>& wrong) {
  MoveCounts counts;
  std::vector<Key> right;
  for (const Move& move : observed) {
    ++counts.observed;
    if (move.turned) {
      ++counts.turned;
      continue;
    }
    if (!move.is_caused() || (move.transition == kNone && !move.spring_return)) {
      ++counts.uncaused;
      continue;
    }
    ++counts.judged;
    const std::string fault = fault_of(real.units[move.unit], move, tolerance);
    if (!fault.empty()) {
      ++counts.wrong;
      wrong.push_back({move, move_text(real, move) + ": " + fault});
      continue;
    }
    right.emplace_back(move.unit, move.from, move.to, move.arrived != kUnknown ? move.arrived : move.left);
  }
  std::sort(right.begin(), right.end());
  for (const TrueMove& move : happened) {
    if (move.arrived < 0 || move.turned) continue;
    ++counts.happened;
    const auto shown = [&](Time end) {
      return std::binary_search(right.begin(), right.end(), Key{move.unit, move.from, move.to, end});
    };
    const bool seen = shown(move.arrived) || shown(move.left);
    const std::vector<model::State>& states = real.units[move.unit].states;
    const bool has_events = states[move.from].event != kNone && states[move.to].event != kNone;
    if (has_events) ++counts.shown;
    if (has_events && seen) ++counts.shown_seen;
    if (seen) ++counts.seen;
  }
  return counts;
}

}  // namespace symplant::property
