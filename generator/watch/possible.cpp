// What a unit may have done by its model, although no reading shows it.
#include "watch/possible.hpp"

#include <algorithm>

namespace symplant::watch {
namespace {

using observe::Move;
using AtomKind = condition::Atom::Kind;

void add_units(const condition::Tree& tree, std::vector<std::uint32_t>& units) {
  const bool of_unit = tree.atom.kind == AtomKind::settled || tree.atom.kind == AtomKind::moving;
  if (tree.kind == condition::Tree::Kind::atom && of_unit) units.push_back(tree.atom.of);
  for (const condition::Tree& child : tree.children) add_units(child, units);
}

/// Whether plant.json gives how long a transition takes.
bool is_time_given(const model::Unit& unit, const model::Transition& transition) {
  if (unit.described == nullptr || transition.given == model::kNone) return false;
  const description::GivenTransition& given = unit.described->transitions[transition.given];
  return given.takes || given.after;
}

}  // namespace

Possible::Possible(const model::PlantModel& plant, const std::vector<bool>& recorded, const observe::Observer& observer,
                   const Margin& margin, const std::vector<Statistic>& learned)
    : plant_(plant),
      recorded_(recorded),
      observer_(observer),
      margin_(margin),
      causes_(plant.units.size()),
      disablers_(plant.units.size()) {
  for (const Statistic& one : learned) learned_.insert({one.unit, one.from, one.to});
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    for (const condition::Tree& tree : plant.units[u].conditions) add_units(tree, causes_[u]);
    for (const auto& disabled : plant.units[u].disables) {
      for (const std::uint32_t other : disabled) {
        causes_[other].push_back(u);
        disablers_[other].push_back(u);
      }
    }
  }
}

Limits Possible::limits(const Move& move) const {
  if (move.unit == kNone) return {};  // nothing is caused any more: the unit may be in one of several states
  const model::Unit& unit = plant_.units[move.unit];
  return unit.has_behaviour() || !is_judged(move) ? Limits{} : limits_of(unit, move);
}

bool Possible::is_judged(const Move& move) const {
  if (learned_.empty()) return true;
  if (move.transition == kNone) return learned_.contains({move.unit, move.from, move.to});
  const model::Transition& transition = plant_.units[move.unit].transitions[move.transition];
  return learned_.contains({move.unit, transition.from, transition.to}) ||
         is_time_given(plant_.units[move.unit], transition);
}

bool Possible::shows(const model::Unit& unit, std::uint32_t state) const {
  if (state == kNone) return false;
  const std::uint32_t event = unit.states[state].event;
  if (event != kNone && recorded_[unit.events[event]]) return true;
  if (unit.outputs.empty()) return false;
  const auto& enter = unit.outputs[state].enter;
  return std::any_of(enter.begin(), enter.end(),
                     [&](const auto& output) { return output.second && recorded_[unit.events[output.first]]; });
}

bool Possible::shows_all(const model::Unit& unit) const {
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    if (!shows(unit, s)) return false;
  }
  return true;
}

bool Possible::may_have_cause(const Move& move, const Move& canceled) const {
  const model::Unit& unit = plant_.units[move.unit];
  // With a transition a cause may hold, which depends on what is not recorded.
  if (move.from == kNone || move.transition != kNone || move.spring_return) return true;
  // What only people move, or custom code.
  if (!unit.moves() || unit.has_behaviour()) return true;
  if (canceled.from != move.from || canceled.cause == kUnknown) return false;
  const Limits limits = this->limits(canceled);
  const Time end = move.left != kUnknown ? move.left : move.arrived;
  return limits.known && end - canceled.cause <= limits.after.most + margin_.of(limits.total().most);
}

bool Possible::is_cause(const Move& move, std::uint32_t symbol, bool on) const {
  const model::Unit& unit = plant_.units[move.unit];
  const auto fits = [&](std::uint32_t to) { return move.to == kNone || move.to == to; };
  if (!on) return unit.actuation == tables::Actuation::spring && fits(unit.rest);
  return std::any_of(unit.transitions.begin(), unit.transitions.end(), [&](const model::Transition& transition) {
    const bool commanded = transition.on != kNone && unit.operations[transition.on] == symbol;
    return commanded && transition.from == move.from && fits(transition.to);
  });
}

/// How long a unit moves on by a transition by which it may have left its state between two readings.
std::optional<Range> Possible::onward(const model::Unit& unit, std::uint32_t transition) const {
  Move move;
  move.transition = transition;
  const Limits limits = unit.has_behaviour() ? Limits{} : limits_of(unit, move);
  if (!limits.known || limits.after.least > 2 * margin_.resolution) return std::nullopt;
  return limits.takes;
}

bool Possible::hides_cause(const Move& move) const {
  const model::Unit& unit = plant_.units[move.unit];
  Move commanded = move;
  for (std::uint32_t t = 0; t < unit.transitions.size(); ++t) {
    const model::Transition& transition = unit.transitions[t];
    if (transition.from != move.from || transition.to != move.to || transition.on == kNone) continue;
    commanded.transition = t;
    const Limits limits = this->limits(commanded);
    if (limits.known && limits.total().least < margin_.resolution) return true;
  }
  return passes_through(move);
}

bool Possible::passes_through(const Move& move) const {
  const model::Unit& unit = plant_.units[move.unit];
  const Time took = move.left == kUnknown ? kUnknown : move.arrived - move.left;
  for (std::uint32_t f = 0; f < unit.transitions.size(); ++f) {
    const model::Transition& first = unit.transitions[f];
    if (first.from != move.from || first.to == move.to || first.spring_return) continue;
    for (std::uint32_t t = 0; t < unit.transitions.size(); ++t) {
      if (unit.transitions[t].from != first.to || unit.transitions[t].to != move.to) continue;
      const std::optional<Range> second = onward(unit, t);
      if (!second) continue;
      Move begin = move;
      begin.transition = f;
      const Limits limits = this->limits(begin);
      if (took == kUnknown || !limits.known) return true;
      const Time most = limits.takes.most + second->most;
      const Time margin = margin_.of(most) + 2 * margin_.resolution;
      if (took - move.stopped <= most + margin && took >= limits.takes.least + second->least - margin) return true;
    }
  }
  return false;
}

Time Possible::longer_by(const Move& move) const {
  const model::Unit& unit = plant_.units[move.unit];
  Time longest = 0;
  for (std::uint32_t t = 0; t < unit.transitions.size(); ++t) {
    const model::Transition& transition = unit.transitions[t];
    if (transition.from != move.to || transition.spring_return) continue;
    if (transition.on != kNone) {
      const std::uint32_t symbol = unit.operations[transition.on];
      if ((observer_.value(symbol) != 0) == plant_.symbols[symbol].inverted) continue;
    }
    const std::optional<Range> second = onward(unit, t);
    if (second) longest = std::max(longest, second->most + margin_.of(second->most));
  }
  return longest;
}

bool Possible::may_begin_midway(const Move& move) const {
  constexpr Time kRests = 3;  // how many times as long as the move a return is taken to last at most
  if (shows(plant_.units[move.unit], move.from) || move.since == kUnknown) return false;
  return move.cause - move.since < kRests * limits(move).total().most;
}

bool Possible::may_be_stopped(const Move& move) const {
  const model::Unit& unit = plant_.units[move.unit];
  if (move.transition != kNone) {
    const std::uint32_t during = unit.transitions[move.transition].during;
    if (during != kNone && !is_known(unit.conditions[during])) return true;
  }
  return std::any_of(disablers_[move.unit].begin(), disablers_[move.unit].end(),
                     [&](std::uint32_t other) { return observer_.view(other).state == kNone; });
}

bool Possible::is_known(const condition::Tree& tree) const {
  if (tree.kind == condition::Tree::Kind::constant) return true;
  if (tree.kind == condition::Tree::Kind::atom) {
    const condition::Atom& atom = tree.atom;
    if (atom.kind == AtomKind::bit || atom.kind == AtomKind::number) return recorded_[atom.of];
    const bool of_unit = atom.kind == AtomKind::settled || atom.kind == AtomKind::moving;
    return of_unit && observer_.view(atom.of).state != kNone;
  }
  return std::all_of(tree.children.begin(), tree.children.end(),
                     [this](const condition::Tree& child) { return is_known(child); });
}

}  // namespace symplant::watch
