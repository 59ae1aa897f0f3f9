// Which symbols make a unit, how they are related, and what the description defines for it.
#include <algorithm>

#include "support/reference/material.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

char upper_letter(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::uint32_t find_task(const Rules& rules, const std::vector<std::uint32_t>& symbols, std::string_view task) {
  for (std::uint32_t i = 0; i < symbols.size(); ++i) {
    if (same_name(rules.model->symbols[symbols[i]].reading.task(), task)) return i;
  }
  return kNone;
}

UnitRules gather(const Rules& rules, std::uint32_t index) {
  const model::PlantModel& model = *rules.model;
  UnitRules unit;
  unit.path = model.units[index].path;
  for (const description::DeviceDescription& device : model.description->devices) {
    if (same_name(device.path, unit.path)) unit.described = &device;
  }
  if (const pairing::Facet* facet = model.units[index].facet; facet != nullptr) {
    unit.described = model.units[index].described;
    unit.sequence = facet->numbered;
    unit.archetype = facet->by == pairing::FacetBy::archetype;
    unit.order = facet->states;
    for (const pairing::Member& member : facet->members) {
      if (!member.makes_state) unit.reports.insert(member.input);
    }
  }
  for (std::uint32_t i = 0; i < model.symbols.size(); ++i) {
    const model::Symbol& symbol = model.symbols[i];
    if (symbol.unit == index) {
      (symbol.direction == tables::Direction::operation ? unit.operations : unit.events).push_back(i);
    }
    const bool named = symbol.reading.is_named() && !senses_parts(model, i) && !writes_signal(rules, i);
    if (named && !rules.is_bool(i) && same_name(symbol.reading.device_path(), unit.path)) {
      unit.values.push_back(i);
    }
  }
  if (unit.described != nullptr) {
    const auto found = rules.behaviours.find(unit.described->behaviour);
    if (found != rules.behaviours.end()) unit.behaviour = &found->second;
  }
  for (const condition::Tree& tree : model.units[index].conditions) unit.conditions.push_back(&tree);
  unit.travel = model.description->defaults.travel;
  return unit;
}

void derive_outputs(Rules& rules, UnitRules& unit) {
  for (StateRules& state : unit.states) {
    if (state.event == kNone) continue;
    state.enter.emplace_back(state.event, true);
    state.leave.emplace_back(state.event, false);
  }
  if (unit.described == nullptr) return;
  for (const description::GivenOutputs& given : unit.described->outputs) {
    const std::uint32_t state = find_state(unit, given.state);
    if (state == kNone) {
      rules.fault = unit.path + ": outputs of " + given.state + ", which is no state";
      continue;
    }
    for (const auto& [task, on] : given.enter) {
      unit.states[state].enter.emplace_back(find_event(rules, unit, task), on);
    }
    for (const auto& [task, on] : given.leave) {
      unit.states[state].leave.emplace_back(find_event(rules, unit, task), on);
    }
  }
  for (const StateRules& state : unit.states) {
    for (const auto* list : {&state.enter, &state.leave}) {
      for (const auto& [event, on] : *list) {
        if (event == kNone) rules.fault = unit.path + ": outputs of " + state.name + " name an event that is none";
      }
    }
  }
}

void derive_disables(Rules& rules, std::uint32_t index) {
  UnitRules& unit = rules.units[index];
  if (unit.described == nullptr) return;
  for (const description::GivenDisables& given : unit.described->disables) {
    const std::uint32_t state = find_state(unit, given.state);
    if (state == kNone) {
      rules.fault = unit.path + ": disables of " + given.state + ", which is no state";
      continue;
    }
    for (const std::string& device : given.devices) {
      for (std::uint32_t other = 0; other < rules.units.size(); ++other) {
        if (other == index || !same_name(rules.units[other].path, device)) continue;
        std::vector<std::uint32_t>& disabled = unit.states[state].disables;
        if (std::find(disabled.begin(), disabled.end(), other) == disabled.end()) disabled.push_back(other);
      }
    }
    std::sort(unit.states[state].disables.begin(), unit.states[state].disables.end());
  }
}

}  // namespace

std::string upper(std::string_view name) {
  std::string text(name);
  std::transform(text.begin(), text.end(), text.begin(), upper_letter);
  return text;
}

bool same_name(std::string_view a, std::string_view b) { return upper(a) == upper(b); }

std::string sequence_number(std::string_view name) {
  std::size_t first = name.size();
  while (first > 0 && name[first - 1] >= '0' && name[first - 1] <= '9') --first;
  while (first + 1 < name.size() && name[first] == '0') ++first;
  return std::string(name.substr(first));
}

std::string UnitRules::number_of(const StateRules& state) const {
  return sequence && state.numbered ? sequence_number(state.name) : std::string();
}

bool lower_number(const std::string& a, const std::string& b) {
  return a.size() != b.size() ? a.size() < b.size() : a < b;
}

std::uint32_t find_state(const UnitRules& unit, std::string_view name) {
  for (std::uint32_t i = 0; i < unit.states.size(); ++i) {
    if (same_name(unit.states[i].name, name)) return i;
  }
  return kNone;
}

std::uint32_t find_operation(const Rules& rules, const UnitRules& unit, std::string_view task) {
  return find_task(rules, unit.operations, task);
}

std::uint32_t find_event(const Rules& rules, const UnitRules& unit, std::string_view task) {
  return find_task(rules, unit.events, task);
}

bool UnitRules::leads_to(std::uint32_t operation, std::uint8_t state) const {
  if (states[state].operation == operation) return true;
  for (const Transition& transition : transitions) {
    if (transition.to == state && transition.on == operation) return true;
  }
  return false;
}

bool UnitRules::event_is_a_state(std::uint32_t event) const {
  for (const StateRules& state : states) {
    if (state.event == event) return true;
  }
  return false;
}

std::uint32_t Rules::leader(std::uint32_t symbol) const {
  const std::uint32_t leader = model->symbols[symbol].leader;
  return leader == model::kNone ? symbol : leader;
}

std::vector<std::uint32_t> Rules::together(std::uint32_t symbol) const {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < model->symbols.size(); ++i) {
    if (leader(i) == leader(symbol)) all.push_back(i);
  }
  return all;
}

bool Rules::follows_condition(std::uint32_t symbol) const {
  return std::any_of(follows.begin(), follows.end(),
                     [&](const FollowRules& follow) { return follow.symbol == symbol; });
}

// A unit drives an event if it can move and switches the event on entering or leaving a state that it is in
// at the start or can reach. User code may switch any event of its unit.
bool Rules::moved(std::uint32_t symbol) const {
  const std::uint32_t first = leader(symbol);
  if (follows_condition(first) || senses_parts(*model, first) || writes_signal(*this, first)) return true;
  const std::uint32_t owner = model->symbols[first].unit;
  if (is_operation(symbol) || owner == model::kNone) return false;
  const UnitRules& unit = units[owner];
  if (unit.behaviour != nullptr) return true;
  if (unit.transitions.empty() && !unit.spring()) return false;
  for (std::uint8_t i = 0; i < unit.states.size(); ++i) {
    bool reached = i == unit.initial || (unit.spring() && i == unit.rest);
    for (const Transition& transition : unit.transitions) reached = reached || transition.to == i;
    if (!reached) continue;
    for (const auto* list : {&unit.states[i].enter, &unit.states[i].leave}) {
      for (const auto& [event, on] : *list) {
        if (leader(unit.events[event]) == first) return true;
      }
    }
  }
  return false;
}

Rules derive(const model::PlantModel& model, std::map<std::string, Behaviour> behaviours) {
  Rules rules;
  rules.model = &model;
  rules.behaviours = std::move(behaviours);
  derive_symbols(rules);
  derive_signal_symbols(rules);
  for (std::uint32_t i = 0; i < model.units.size(); ++i) {
    UnitRules unit = gather(rules, i);
    derive_states(rules, unit);
    derive_actuation_and_initial(rules, unit);
    derive_transitions(rules, unit);
    derive_outputs(rules, unit);
    rules.units.push_back(std::move(unit));
  }
  for (std::uint32_t i = 0; i < model.units.size(); ++i) derive_disables(rules, i);
  derive_values(rules);
  return rules;
}

}  // namespace symplant::reference
