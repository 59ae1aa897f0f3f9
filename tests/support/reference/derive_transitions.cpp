// The table of transitions: given, derived and inferred ones.
#include <algorithm>

#include "support/reference/rules.hpp"

namespace symplant::reference {
namespace {

using description::Duration;

/// The distinct texts of `when` and `while` of the unit's given transitions, by first appearance.
std::vector<std::string> condition_texts(const UnitRules& unit) {
  std::vector<std::string> texts;
  if (unit.described == nullptr) return texts;
  for (const description::GivenTransition& given : unit.described->transitions) {
    for (const std::string* text : {&given.when, &given.during}) {
      if (!text->empty() && std::find(texts.begin(), texts.end(), *text) == texts.end()) texts.push_back(*text);
    }
  }
  return texts;
}

/// kNone without a text.
std::uint32_t condition_index(const UnitRules& unit, const std::string& text) {
  if (text.empty()) return kNone;
  const std::vector<std::string> texts = condition_texts(unit);
  return static_cast<std::uint32_t>(std::find(texts.begin(), texts.end(), text) - texts.begin());
}

void add_given(Rules& rules, UnitRules& unit, const description::GivenTransition& given) {
  const std::uint32_t to = find_state(unit, given.to);
  const std::uint32_t from = given.from == "*" ? kNone : find_state(unit, given.from);
  if (to == kNone || (given.from != "*" && from == kNone)) {
    rules.fault = unit.path + ": a transition from " + given.from + " to " + given.to + ", of which one is no state";
    return;
  }
  Transition transition;
  transition.to = static_cast<std::uint8_t>(to);
  transition.automatic = given.automatic;
  transition.once = given.once;
  if (!given.automatic) {
    transition.on = given.on.empty() ? unit.states[to].operation : find_operation(rules, unit, given.on);
    const bool spring_return = given.on.empty() && unit.spring() && to == unit.rest;
    if (transition.on == kNone && !spring_return)
      rules.fault = unit.path + ": nothing commands the transition to " + given.to;
  }
  transition.after = given.after.value_or(Duration::fixed(0));
  transition.takes = given.takes.value_or(Duration::fixed(given.automatic ? 0 : unit.travel));
  transition.when = condition_index(unit, given.when);
  transition.during = condition_index(unit, given.during);
  transition.weight = given.numbers.weight;
  for (std::uint32_t i = 0; i < unit.states.size(); ++i) {
    if (i == to || (given.from != "*" && i != from)) continue;
    transition.from = static_cast<std::uint8_t>(i);
    unit.transitions.push_back(transition);
  }
}

bool commanded_given(const std::vector<Transition>& given, const Transition& derived) {
  for (const Transition& transition : given) {
    if (transition.commanded() && transition.from == derived.from && transition.on == derived.on) return true;
  }
  return false;
}

bool automatic_given(const std::vector<Transition>& given, const Transition& inferred) {
  for (const Transition& transition : given) {
    if (transition.automatic && transition.from == inferred.from && transition.to == inferred.to) return true;
  }
  return false;
}

/// The next higher number among the unit's; the lowest after the highest, and then `wraps`.
std::string next_number(const UnitRules& unit, const std::string& number, bool& wraps) {
  std::string next;
  std::string lowest = number;
  for (const StateRules& state : unit.states) {
    const std::string other = unit.number_of(state);
    if (other.empty()) continue;
    if (lower_number(other, lowest)) lowest = other;
    if (lower_number(number, other) && (next.empty() || lower_number(other, next))) next = other;
  }
  wraps = next.empty();
  return wraps ? lowest : next;
}

/// Whether a derived d_ext may lead from one state to another.
bool joins(const UnitRules& unit, description::Sequence sequence, std::uint8_t from, std::uint8_t to) {
  const std::string a = unit.number_of(unit.states[from]);
  const std::string b = unit.number_of(unit.states[to]);
  if (sequence == description::Sequence::free || a.empty() || b.empty()) return true;
  bool wraps = false;
  if (sequence == description::Sequence::cycle) return next_number(unit, a, wraps) == b;
  const bool up = next_number(unit, a, wraps) == b && !wraps;
  const bool down = next_number(unit, b, wraps) == a && !wraps;
  return up || down;
}

void add_derived(const Rules& rules, UnitRules& unit, const std::vector<Transition>& given) {
  description::Sequence sequence = rules.model->description->defaults.sequence;
  if (unit.described != nullptr) sequence = unit.described->sequence.value_or(sequence);

  for (std::uint8_t to = 0; to < unit.states.size(); ++to) {
    if (unit.states[to].operation == kNone) continue;
    for (std::uint8_t from = 0; from < unit.states.size(); ++from) {
      if (from == to || !joins(unit, sequence, from, to)) continue;
      Transition transition;
      transition.from = from;
      transition.to = to;
      transition.on = unit.states[to].operation;
      transition.after = Duration::fixed(0);
      transition.takes = Duration::fixed(unit.travel);
      if (!commanded_given(given, transition)) unit.transitions.push_back(transition);
    }
  }
}

/// Inference 3: the state from which an automatic transition leads to a numbered one; kNone if it is not unique.
std::uint32_t predecessor(const UnitRules& unit, const std::string& number) {
  std::string lower;    // the highest number below
  std::string highest;  // of all
  for (const StateRules& state : unit.states) {
    const std::string other = unit.number_of(state);
    if (other.empty()) continue;
    if (highest.empty() || lower_number(highest, other)) highest = other;
    if (lower_number(other, number) && (lower.empty() || lower_number(lower, other))) lower = other;
  }
  const std::string& wanted = lower.empty() ? highest : lower;
  std::uint32_t found = kNone;
  for (std::uint32_t i = 0; i < unit.states.size(); ++i) {
    if (unit.number_of(unit.states[i]) != wanted) continue;
    if (found != kNone) return kNone;
    found = i;
  }
  return found;
}

void add_inferred(const Rules& rules, UnitRules& unit, const std::vector<Transition>& given) {
  if (unit.actuation != tables::Actuation::latched) return;
  bool some_operation = false;
  for (const StateRules& state : unit.states) {
    some_operation = some_operation || (!unit.number_of(state).empty() && state.operation != kNone);
  }
  if (!some_operation) return;
  for (std::uint8_t to = 0; to < unit.states.size(); ++to) {
    const StateRules& state = unit.states[to];
    bool led_to = state.operation != kNone;
    for (const Transition& transition : given) led_to = led_to || (transition.commanded() && transition.to == to);
    const std::string number = unit.number_of(state);
    if (number.empty() || state.event == kNone || led_to) continue;
    const std::uint32_t from = predecessor(unit, number);
    if (from == kNone || from == to) continue;
    Transition transition;
    transition.from = static_cast<std::uint8_t>(from);
    transition.to = to;
    transition.automatic = true;
    transition.after = Duration::fixed(rules.model->description->defaults.dwell);
    transition.takes = Duration::fixed(0);
    if (!automatic_given(given, transition)) unit.transitions.push_back(transition);
  }
}

}  // namespace

void derive_transitions(Rules& rules, UnitRules& unit) {
  unit.first_input = static_cast<std::uint32_t>(condition_texts(unit).size());
  if (unit.described != nullptr) {
    for (const description::GivenTransition& given : unit.described->transitions) add_given(rules, unit, given);
    if (unit.described->only) return;
  }
  const std::vector<Transition> given = unit.transitions;
  add_derived(rules, unit, given);
  add_inferred(rules, unit, given);
}

}  // namespace symplant::reference
