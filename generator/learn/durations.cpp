// Times of moves, by unit and transition.
#include "learn/durations.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "observe/observer.hpp"

namespace symplant::learn {
namespace {

using observe::kUnknown;
using observe::Move;

/// Whether it went from one known state to another.
bool is_whole(const Move& move) {
  return move.from != kNone && move.to != kNone && move.from != move.to &&
         (move.left != kUnknown || move.arrived != kUnknown);
}

/// Whether it is the return of a spring that no transition of the model is.
bool is_return(const Move& move) { return move.transition == kNone && move.spring_return; }

/// Whether its times are those of a transition.
bool is_timed(const Move& move) {
  return is_whole(move) && !move.turned && move.is_caused() && (move.transition != kNone || is_return(move));
}

/// The first transition whose times are the entry of plant.json for this move: with the same states and operation, or
/// for the return of a spring with the same states and any operation. kNone: no transition but the spring's.
std::uint32_t first_alike(const model::Unit& unit, const Move& move) {
  const bool returns = is_return(move);
  const std::uint32_t on = returns ? kNone : unit.transitions[move.transition].on;
  const auto found = std::find_if(unit.transitions.begin(), unit.transitions.end(), [&](const model::Transition& one) {
    return one.from == move.from && one.to == move.to && (returns ? one.on != kNone : one.on == on) &&
           !one.spring_return;
  });
  return found == unit.transitions.end() ? kNone : static_cast<std::uint32_t>(found - unit.transitions.begin());
}

TransitionMoves& moves_of_transition(UnitMoves& unit, const Move& move, std::uint32_t transition) {
  const auto found = std::find_if(unit.transitions.begin(), unit.transitions.end(), [&](const TransitionMoves& one) {
    return one.transition == transition && one.from == move.from && one.to == move.to;
  });
  if (found != unit.transitions.end()) return *found;
  return unit.transitions.emplace_back(TransitionMoves{move.unit, move.from, move.to, transition, {}});
}

/// The states of a unit as its moves show them.
void add_states(const Move& move, std::vector<StateChange>& states) {
  if (states.empty() && move.from != kNone) states.push_back({0, move.from});
  if (move.left != kUnknown) states.push_back({move.left, move.arrived == kUnknown ? move.to : kNone});
  if (move.arrived != kUnknown) states.push_back({move.arrived, move.to});
}

/// Series of the symbols of a plant; kNone: not recorded.
std::vector<std::uint32_t> series_by_symbol(const Input& input, std::size_t symbols) {
  std::vector<std::uint32_t> series(symbols, kNone);
  for (std::uint32_t i = 0; i < input.matched.symbols.size(); ++i) {
    if (input.matched.symbols[i] != kNone) series[input.matched.symbols[i]] = i;
  }
  return series;
}

/// The next change to a bit from `from` on; kUnknown: no change follows.
Time next_change_to(const recording::Series& series, bool bit, Time from) {
  auto change = std::lower_bound(series.changes.begin(), series.changes.end(), from,
                                 [](const recording::Series::Change& one, Time time) { return one.time < time; });
  for (; change != series.changes.end(); ++change) {
    if ((change->value != 0) == bit) return change->time;
  }
  return kUnknown;
}

/// Whether a bit has a value at a time, after all changes of that time.
bool has_bit(const recording::Series& series, bool bit, Time time) {
  const auto next = std::upper_bound(series.changes.begin(), series.changes.end(), time,
                                     [](Time at, const recording::Series::Change& one) { return at < one.time; });
  return (next != series.changes.begin() && std::prev(next)->value != 0) == bit;
}

bool in_gap(const recording::Recording& recording, Time begin, Time end) {
  return std::any_of(recording.gaps.begin(), recording.gaps.end(),
                     [&](const recording::Gap& gap) { return gap.begin < end && gap.begin + gap.length > begin; });
}

}  // namespace

MoveCollector::MoveCollector(const model::PlantModel& plant) : plant_(plant), by_unit_(plant.units.size()) {
  moves_.moved.resize(plant.units.size());
  moves_.taken.resize(plant.units.size());
  moves_.unused_of.resize(plant.units.size());
}

void MoveCollector::add_move(const Move& move, std::uint32_t input) {
  if (move.from != kNone) moves_.moved[move.unit] = true;  // else its state was seen for the first time
  add_states(move, moves_.states[input][move.unit]);
  if (!is_whole(move)) return;
  UnusedMoves& of = moves_.unused_of[move.unit];
  of.unit = move.unit;
  if (!is_timed(move)) {
    ++moves_.unused;
    ++(move.turned ? of.turned : of.uncaused);
    return;
  }
  ++moves_.count;
  ++of.used;
  std::vector<bool>& taken = moves_.taken[move.unit];
  const std::vector<model::Transition>& transitions = plant_.units[move.unit].transitions;
  taken.resize(transitions.size());
  for (std::uint32_t i = 0; i < transitions.size(); ++i) {
    const model::Transition& one = transitions[i];
    if (is_return(move) ? one.spring_return && one.from == move.from && one.to == move.to : i == move.transition)
      taken[i] = true;
  }
  const bool rests = move.left == kUnknown && move.since != kUnknown;
  const Time rest = rests ? move.cause - move.since : kUnknown;
  moves_of_transition(by_unit_[move.unit], move, first_alike(plant_.units[move.unit], move))
      .moves.push_back({move.cause, move.left, move.arrived, move.stopped, input, rest});
}

void MoveCollector::add_overruns(const Input& input, const std::vector<Move>& moves, std::uint32_t number) {
  std::vector<std::uint32_t> series;
  for (const Move& move : moves) {
    const model::Unit& unit = plant_.units[move.unit];
    if (unit.actuation != tables::Actuation::held || !is_timed(move) || is_return(move)) continue;
    const std::uint32_t on = unit.transitions[move.transition].on;
    if (on == kNone || move.arrived == kUnknown) continue;
    if (series.empty()) series = series_by_symbol(input, plant_.symbols.size());
    const std::uint32_t symbol = unit.operations[on];
    if (series[symbol] == kNone) continue;
    const recording::Series& operation = input.recording.series[series[symbol]];
    const bool bit_off = plant_.symbols[symbol].inverted;
    const Time off = next_change_to(operation, bit_off, move.arrived);
    if (off == kUnknown || (off > move.arrived && has_bit(operation, bit_off, move.arrived))) continue;
    if (in_gap(input.recording, move.arrived, off)) continue;
    by_unit_[move.unit].overruns.push_back({off - move.arrived, move.arrived, number, move.unit});
  }
}

void MoveCollector::add(const Input& input, const std::vector<Move>& moves) {
  const std::uint32_t number = inputs_++;
  moves_.states.emplace_back(plant_.units.size());
  for (const Move& move : moves) add_move(move, number);
  add_overruns(input, moves, number);
}

Moves MoveCollector::finish() {
  for (std::uint32_t u = 0; u < by_unit_.size(); ++u) {
    UnitMoves& unit = by_unit_[u];
    if (unit.transitions.empty()) continue;
    unit.unit = u;
    std::sort(unit.transitions.begin(), unit.transitions.end(), [](const TransitionMoves& a, const TransitionMoves& b) {
      return std::tie(a.from, a.to, a.transition) < std::tie(b.from, b.to, b.transition);
    });
    moves_.units.push_back(std::move(unit));
  }
  return std::move(moves_);
}

Moves moves_of(const model::PlantModel& plant, const std::vector<Input>& inputs) {
  MoveCollector collector(plant);
  for (const Input& input : inputs) {
    collector.add(input, observe::moves_of(plant, input.recording, input.matched));
  }
  return collector.finish();
}

}  // namespace symplant::learn
