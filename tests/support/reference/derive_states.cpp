// S and its order, actuation, rest and initial state.
#include <algorithm>

#include "support/reference/rules.hpp"

namespace symplant::reference {
namespace {

/// Whether the description names a task as a state anywhere.
bool reported_as_state(const description::DeviceDescription& device, std::string_view task) {
  for (const description::GivenTransition& given : device.transitions) {
    if (same_name(given.from, task) || same_name(given.to, task)) return true;
  }
  for (const std::string& state : device.states) {
    if (same_name(state, task)) return true;
  }
  for (const description::GivenOutputs& given : device.outputs) {
    if (same_name(given.state, task)) return true;
  }
  for (const description::GivenDisables& given : device.disables) {
    if (same_name(given.state, task)) return true;
  }
  return (device.initial && same_name(*device.initial, task)) || (device.rest && same_name(*device.rest, task));
}

bool is_only_a_command(const UnitRules& unit, const StateRules& state) {
  if (unit.described == nullptr || state.event != kNone || reported_as_state(*unit.described, state.name)) return false;
  for (const description::GivenTransition& given : unit.described->transitions) {
    if (same_name(given.on, state.name)) return true;
  }
  return false;
}

bool is_only_a_report(const UnitRules& unit, const StateRules& state) {
  if (state.operation == kNone && unit.reports.count(unit.events[state.event]) != 0) {
    return unit.described == nullptr || !reported_as_state(*unit.described, state.name);
  }
  if (unit.described == nullptr || state.operation != kNone || reported_as_state(*unit.described, state.name))
    return false;
  for (const description::GivenOutputs& given : unit.described->outputs) {
    for (const auto* list : {&given.enter, &given.leave}) {
      for (const auto& [task, on] : *list) {
        if (same_name(task, state.name)) return true;
      }
    }
  }
  return false;
}

/// Every task, by the first row that names it.
std::vector<StateRules> tasks(const Rules& rules, const UnitRules& unit) {
  std::vector<StateRules> found;
  for (std::uint32_t symbol = 0; symbol < rules.model->symbols.size(); ++symbol) {
    const auto operation = std::find(unit.operations.begin(), unit.operations.end(), symbol);
    const auto event = std::find(unit.events.begin(), unit.events.end(), symbol);
    if (operation == unit.operations.end() && event == unit.events.end()) continue;
    const std::string_view task = rules.model->symbols[symbol].reading.task();
    std::size_t index = 0;
    while (index < found.size() && !same_name(found[index].name, task)) ++index;
    if (index == found.size()) found.emplace_back().name = task;
    if (operation != unit.operations.end()) {
      found[index].operation = static_cast<std::uint32_t>(operation - unit.operations.begin());
    } else {
      found[index].event = static_cast<std::uint32_t>(event - unit.events.begin());
    }
  }
  return found;
}

/// Inference 2: the index of Y in S, kNone if the unit is not a single solenoid.
std::uint32_t single_solenoid_rest(const UnitRules& unit) {
  if (unit.states.size() != 2 || unit.archetype) return kNone;
  for (std::uint32_t x = 0; x < 2; ++x) {
    const StateRules& commanded = unit.states[x];
    const StateRules& other = unit.states[1 - x];
    if (commanded.operation != kNone && commanded.event != kNone && other.operation == kNone &&
        unit.number_of(other).empty()) {
      return 1 - x;
    }
  }
  return kNone;
}

/// The only state whose event has Initial TRUE and is not inverted; kNone without such a state or with several.
std::uint32_t initial_by_column(const Rules& rules, const UnitRules& unit) {
  std::uint32_t found = kNone;
  for (std::uint32_t i = 0; i < unit.states.size(); ++i) {
    const std::uint32_t event = unit.states[i].event;
    if (event == kNone || rules.inverted[unit.events[event]]) continue;
    if (rules.model->symbols[unit.events[event]].initial == 0) continue;
    if (found != kNone) return kNone;
    found = i;
  }
  return found;
}

std::uint32_t named_state(Rules& rules, const UnitRules& unit, const std::string& name) {
  const std::uint32_t state = find_state(unit, name);
  if (state == kNone) rules.fault = unit.path + ": " + name + " is no state";
  return state;
}

}  // namespace

void derive_states(Rules& rules, UnitRules& unit) {
  std::vector<StateRules> numbered;
  std::vector<StateRules> others;
  for (const StateRules& state : tasks(rules, unit)) {
    if (is_only_a_command(unit, state) || is_only_a_report(unit, state)) continue;
    (unit.number_of(state).empty() ? others : numbered).push_back(state);
  }
  std::stable_sort(numbered.begin(), numbered.end(), [](const StateRules& a, const StateRules& b) {
    return lower_number(sequence_number(a.name), sequence_number(b.name));
  });
  unit.states = numbered;
  unit.states.insert(unit.states.end(), others.begin(), others.end());
  if (unit.described != nullptr) {
    for (const std::string& state : unit.described->states) unit.states.emplace_back().name = state;
  }
  std::vector<StateRules> ordered;
  for (const std::string& name : unit.order) {
    for (const StateRules& state : unit.states) {
      if (same_name(state.name, name)) ordered.push_back(state);
    }
  }
  for (const StateRules& state : unit.states) {
    const auto same = [&](const std::string& name) { return same_name(state.name, name); };
    if (std::none_of(unit.order.begin(), unit.order.end(), same)) ordered.push_back(state);
  }
  unit.states = ordered;
  unit.no_states = unit.states.empty();
  if (unit.no_states) unit.states.emplace_back().name = "IDLE";
}

void derive_actuation_and_initial(Rules& rules, UnitRules& unit) {
  std::uint32_t inferred_rest = kNone;
  bool inferred_spring = false;
  if (unit.states.size() == 1 && !unit.no_states) {
    // Inference 1.
    StateRules rest;
    rest.name = "NOT_" + unit.states[0].name;
    rest.numbered = false;
    inferred_spring = unit.states[0].operation != kNone;
    unit.states.insert(unit.states.begin(), rest);
    inferred_rest = 0;
  } else {
    inferred_rest = single_solenoid_rest(unit);
    inferred_spring = inferred_rest != kNone;
  }

  unit.actuation = inferred_spring ? tables::Actuation::spring : rules.model->description->defaults.actuation;
  std::uint32_t rest = inferred_rest;
  std::uint32_t initial = kNone;
  if (unit.described != nullptr) {
    if (unit.described->actuation) unit.actuation = *unit.described->actuation;
    if (unit.described->rest && unit.spring()) rest = named_state(rules, unit, *unit.described->rest);
    if (unit.described->initial) initial = named_state(rules, unit, *unit.described->initial);
  }
  if (initial == kNone) initial = initial_by_column(rules, unit);
  if (initial == kNone) initial = rest;
  if (initial == kNone) initial = 0;
  if (unit.states.empty()) rules.fault = unit.path + ": no state";
  unit.initial = static_cast<std::uint8_t>(initial);
  if (unit.spring()) unit.rest = rest != kNone ? rest : initial;
  unit.any_rest = unit.spring() ? unit.rest : rest;
  if (unit.actuation != tables::Actuation::held) return;
  unit.overrun = rules.model->description->defaults.overrun;
  if (unit.described != nullptr && unit.described->overrun) unit.overrun = *unit.described->overrun;
}

}  // namespace symplant::reference
