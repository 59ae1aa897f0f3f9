// Which states a plant comes into.
#include "check/reachability/reach.hpp"

#include <algorithm>

namespace symplant::check {
namespace {

using condition::Atom;
using condition::Tree;

void add_units(const Tree& tree, std::vector<std::uint32_t>& units) {
  const bool of_unit = tree.atom.kind == Atom::Kind::settled || tree.atom.kind == Atom::Kind::moving;
  if (tree.kind == Tree::Kind::atom && of_unit) units.push_back(tree.atom.of);
  for (const Tree& child : tree.children) add_units(child, units);
}

bool is_automatic(const model::Transition& transition) {
  return transition.on == model::kNone && !transition.spring_return;
}

}  // namespace

Reach::Reach(const model::PlantModel& plant)
    : plant_(plant), asking_(plant.units.size()), overtakers_(plant.units.size()) {
  const auto count = static_cast<std::uint32_t>(plant.units.size());
  reached_.reserve(count);
  for (const model::Unit& unit : plant.units) reached_.emplace_back(unit.states.size());
  for (std::uint32_t u = 0; u < count; ++u) {
    std::vector<std::uint32_t> named;
    for (const Tree& tree : plant.units[u].conditions) add_units(tree, named);
    std::sort(named.begin(), named.end());
    named.erase(std::unique(named.begin(), named.end()), named.end());
    for (const std::uint32_t other : named) asking_[other].push_back(u);
  }
  for (std::uint32_t u = 0; u < count; ++u) find_overtakers(u);
  for (std::uint32_t u = 0; u < count; ++u) start(u);
  while (!open_.empty()) {
    const Location location = open_.back();
    open_.pop_back();
    go_on_from(location);
    ask_again(location.unit);
  }
}

bool Reach::moving(std::uint32_t unit) const { return travels(plant_.units[unit]); }

void Reach::start(std::uint32_t unit) {
  const model::Unit& u = plant_.units[unit];
  if (u.has_behaviour() || !u.moves()) {
    for (std::uint32_t s = 0; s < u.states.size(); ++s) reach(unit, s);
    return;
  }
  reach(unit, u.initial);
  if (u.actuation == tables::Actuation::spring) reach(unit, u.rest);
}

void Reach::reach(std::uint32_t unit, std::uint32_t state) {
  if (reached_[unit][state]) return;
  reached_[unit][state] = true;
  open_.push_back({unit, state});
}

void Reach::go_on_from(const Location& location) {
  for (const model::Transition& transition : plant_.units[location.unit].transitions) {
    if (transition.from != location.state || reached_[location.unit][transition.to]) continue;
    if (blocked(location.unit, transition) == Blocked::no) reach(location.unit, transition.to);
  }
}

/// A state more of a unit: conditions that name it may hold now.
void Reach::ask_again(std::uint32_t about) {
  for (const std::uint32_t other : asking_[about]) {
    for (const model::Transition& transition : plant_.units[other].transitions) {
      if (transition.when == model::kNone || !reached_[other][transition.from] || reached_[other][transition.to])
        continue;
      if (blocked(other, transition) == Blocked::no) reach(other, transition.to);
    }
  }
}

void Reach::find_overtakers(std::uint32_t unit) {
  const model::Unit& u = plant_.units[unit];
  std::vector<std::uint32_t>& first = overtakers_[unit];
  for (std::uint32_t i = 0; i < u.transitions.size(); ++i) {
    const model::Transition& transition = u.transitions[i];
    if (!is_automatic(transition) || !transition.after.is_zero()) continue;
    const bool always =
        transition.when == model::kNone || decide(u.conditions[transition.when], plant_, AllStates(plant_)).always();
    if (!always) continue;
    if (first.empty()) first.assign(u.states.size(), model::kNone);
    if (first[transition.from] == model::kNone) first[transition.from] = i;
  }
}

bool Reach::may_hold(const model::Unit& unit, std::uint32_t condition) const {
  return condition == model::kNone || !decide(unit.conditions[condition], plant_, *this).never();
}

Blocked Reach::blocked(std::uint32_t unit, const model::Transition& transition) const {
  const model::Unit& u = plant_.units[unit];
  if (u.has_behaviour()) return Blocked::no;
  if (!may_hold(u, transition.when)) {
    return decide(u.conditions[transition.when], plant_, AllStates(plant_)).never() ? Blocked::contradiction
                                                                                    : Blocked::waits;
  }
  const std::uint32_t first = overtakers_[unit].empty() ? model::kNone : overtakers_[unit][transition.from];
  if (first == model::kNone) return Blocked::no;
  const auto location = static_cast<std::uint32_t>(&transition - u.transitions.data());
  // Conditional automatic transitions that come before it fire first if their conditions hold.
  return location == first || (is_automatic(transition) && location < first) ? Blocked::no : Blocked::overtaken;
}

bool Reach::can_leave(std::uint32_t unit, std::uint32_t state) const {
  const model::Unit& u = plant_.units[unit];
  if (u.has_behaviour() || (u.actuation == tables::Actuation::spring && state != u.rest)) return true;
  return std::any_of(u.transitions.begin(), u.transitions.end(), [&](const model::Transition& transition) {
    return transition.from == state && blocked(unit, transition) == Blocked::no;
  });
}

}  // namespace symplant::check
