// Compares the two derivations unit by unit.
#include "support/reference/difference.hpp"

#include <sstream>

namespace symplant::reference {
namespace {

std::string text(const description::Duration& duration) {
  std::ostringstream out;
  switch (duration.kind) {
    case description::Duration::Kind::fixed:
      out << duration.a;
      break;
    case description::Duration::Kind::uniform:
      out << "min " << duration.a << " max " << duration.b;
      break;
    case description::Duration::Kind::normal:
      out << "mean " << duration.a << " sigma " << duration.b;
      break;
    case description::Duration::Kind::seconds:
      out << *duration.formula << " s";
      break;
  }
  return out.str();
}

std::string number(std::uint32_t index) { return index == kNone ? "-" : std::to_string(index); }

/// Of either kind of transition.
template <class Transition>
std::string text(const Transition& transition, std::uint32_t weight, bool spring_return) {
  std::ostringstream out;
  out << transition.from + 0U << "->" << transition.to + 0U << " on " << number(transition.on) << " when "
      << number(transition.when) << " while " << number(transition.during) << " weight " << weight
      << (spring_return ? " spring's way" : "") << (transition.once ? " once" : "") << " after "
      << text(transition.after) << " takes " << text(transition.takes);
  return out.str();
}

std::string states_text(const UnitRules& unit) {
  std::ostringstream out;
  for (const StateRules& state : unit.states) {
    out << state.name << "(" << number(state.operation) << "," << number(state.event) << ") ";
  }
  return out.str();
}

std::string states_text(const model::Unit& unit) {
  std::ostringstream out;
  for (const model::State& state : unit.states) {
    out << state.name << "(" << number(state.operation) << "," << number(state.event) << ") ";
  }
  return out.str();
}

/// "what: here ..., in the model ..."; empty if both are equal.
std::string unequal(const std::string& what, const std::string& here, const std::string& there) {
  return here == there ? "" : what + ": reference `" + here + "`, model `" + there + "`";
}

std::string switched(const std::vector<std::pair<std::uint32_t, bool>>& events, std::size_t skip) {
  std::ostringstream out;
  for (std::size_t i = skip; i < events.size(); ++i) out << events[i].first << "=" << events[i].second << " ";
  return out.str();
}

std::string indexes(const std::vector<std::uint32_t>& list) {
  std::ostringstream out;
  for (const std::uint32_t index : list) out << index << " ";
  return out.str();
}

std::string transitions_difference(const UnitRules& unit, const model::Unit& other) {
  std::ostringstream here;
  std::ostringstream there;
  for (std::size_t i = 0; i < unit.transitions.size() || i < other.transitions.size(); ++i) {
    std::string ours;
    std::string theirs;
    if (i < unit.transitions.size()) {
      const Transition& transition = unit.transitions[i];
      ours = text(transition, transition.weight, !transition.automatic && !transition.commanded());
    }
    if (i < other.transitions.size()) {
      const model::Transition& transition = other.transitions[i];
      theirs = text(transition, transition.numbers.weight, transition.spring_return);
    }
    if (const auto found = unequal("transition " + std::to_string(i), ours, theirs); !found.empty()) return found;
  }
  return "";
}

std::string state_difference(const UnitRules& unit, const model::Unit& other, std::size_t index) {
  const StateRules& state = unit.states[index];
  const std::size_t own = state.event == kNone ? 0 : 1;
  const model::Outputs outputs = other.outputs.empty() ? model::Outputs{} : other.outputs[index];
  std::string found = unequal("l_enter of " + state.name, switched(state.enter, own), switched(outputs.enter, 0));
  if (found.empty()) {
    found = unequal("l_leave of " + state.name, switched(state.leave, own), switched(outputs.leave, 0));
  }
  if (found.empty()) {
    const auto disables = other.disables.empty() ? std::vector<std::uint32_t>{} : other.disables[index];
    found = unequal("disables of " + state.name, indexes(state.disables), indexes(disables));
  }
  return found;
}

std::string unit_difference(const UnitRules& unit, const model::Unit& other) {
  std::string found = unequal("operations", indexes(unit.operations), indexes(other.operations));
  if (found.empty()) found = unequal("events", indexes(unit.events), indexes(other.events));
  if (found.empty()) found = unequal("states", states_text(unit), states_text(other));
  if (found.empty()) {
    found = unequal("actuation", std::to_string(static_cast<int>(unit.actuation)),
                    std::to_string(static_cast<int>(other.actuation)));
  }
  if (found.empty() && unit.spring()) found = unequal("rest", number(unit.rest), number(other.rest));
  if (found.empty()) found = unequal("initial", std::to_string(unit.initial), std::to_string(other.initial));
  if (found.empty()) found = unequal("travel", std::to_string(unit.travel), std::to_string(other.travel));
  if (found.empty()) found = unequal("overrun", std::to_string(unit.overrun), std::to_string(other.overrun));
  if (found.empty()) found = transitions_difference(unit, other);
  for (std::size_t i = 0; found.empty() && i < unit.states.size(); ++i) found = state_difference(unit, other, i);
  if (found.empty()) found = unequal("values", indexes(unit.values), indexes(other.values));
  const std::size_t inputs = unit.described == nullptr ? 0 : unit.described->inputs.size();
  if (found.empty()) {
    found = unequal("conditions", std::to_string(unit.first_input + inputs), std::to_string(other.conditions.size()));
  }
  if (found.empty() && inputs > 0) {
    found = unequal("first input", std::to_string(unit.first_input), std::to_string(other.first_input));
  }
  return found;
}

std::string symbols_difference(const Rules& rules) {
  const model::PlantModel& model = *rules.model;
  for (std::size_t i = 0; i < model.symbols.size(); ++i) {
    if (rules.inverted[i] == model.symbols[i].inverted) continue;
    return std::string(model.symbols[i].name()) + (rules.inverted[i] ? ": inverted" : ": not inverted");
  }
  for (const FollowRules& follow : rules.follows) {
    if (model.symbols[follow.symbol].unit != model::kNone) return "a symbol that follows is in a unit";
  }
  std::ostringstream here;
  for (const FollowRules& follow : rules.follows) here << follow.symbol << " by " << follow.given << " ";
  std::ostringstream there;
  for (const model::Follow& follow : model.follows) there << follow.symbol << " by " << follow.given << " ";
  return unequal("follow", here.str(), there.str());
}

}  // namespace

std::string difference(const Rules& rules) {
  if (!rules.fault.empty()) return rules.fault;
  const model::PlantModel& model = *rules.model;
  if (std::string found = symbols_difference(rules); !found.empty()) return found;
  for (std::size_t i = 0; i < rules.units.size(); ++i) {
    const std::string found = unit_difference(rules.units[i], model.units[i]);
    if (!found.empty()) return rules.units[i].path + ": " + found;
  }
  return unequal("requirements", std::to_string(model.description->requirements.size()),
                 std::to_string(model.requirements.size()));
}

}  // namespace symplant::reference
