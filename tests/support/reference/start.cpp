// The world before the first instant, and how time passes.
#include "support/reference/start.hpp"

#include "support/reference/material.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {
UnitWorld first_world(const UnitRules& rules) {
  UnitWorld unit;
  unit.state = unit.target = rules.initial;
  unit.transitions.resize(rules.transitions.size());
  unit.operations.resize(rules.operations.size());
  if (rules.behaviour != nullptr) unit.memory.resize((rules.behaviour->memory_size + 7) / 8);
  return unit;
}

/// The value of a symbol before any unit has entered its initial state.
std::uint64_t first_value(const Rules& rules, std::uint32_t index) {
  const model::Symbol& symbol = rules.model->symbols[index];
  // A sensor starts as if its location were empty.
  if (senses_parts(*rules.model, index)) return rules.turned(index, 0);
  if (writes_signal(rules, index)) return 0;
  if (!rules.is_bool(index)) return symbol.initial;
  if (rules.is_operation(index) || rules.follows_condition(index)) return rules.turned(index, 0);
  if (symbol.unit != model::kNone) {
    // If the event of a unit's state is at the address, the state decides.
    const UnitRules& unit = rules.units[symbol.unit];
    for (std::uint32_t i = 0; i < unit.events.size(); ++i) {
      if (rules.leader(unit.events[i]) == index && unit.event_is_a_state(i)) {
        return rules.turned(index, 0);
      }
    }
  }
  return symbol.initial != 0 ? 1 : 0;
}

}  // namespace

InstantNotes empty_notes(const Rules& rules) {
  InstantNotes notes;
  notes.steps.resize(steppers(rules).end);
  notes.enabled.resize(rules.units.size());
  notes.looks.resize(rules.units.size());
  for (const UnitRules& unit : rules.units) notes.served.emplace_back(unit.operations.size());
  notes.event_changed.resize(rules.model->symbols.size());
  return notes;
}

World first_world(const Rules& rules) {
  World world;
  world.rules = &rules;
  for (const UnitRules& unit : rules.units) world.units.push_back(first_world(unit));
  for (std::uint32_t i = 0; i < rules.model->symbols.size(); ++i) {
    SymbolWorld symbol;
    symbol.value = symbol.written = first_value(rules, rules.leader(i));
    // Off; an event on the address of another one as if that were off.
    symbol.shown = rules.is_bool(i) ? rules.turned(rules.is_operation(i) ? i : rules.leader(i), 0) : symbol.value;
    world.symbols.push_back(symbol);
  }
  world.monitors.resize(rules.model->requirements.size());
  world.frozen_follows.resize(rules.follows.size());
  world.material = world.shown_material = first_material(rules);
  world.values = first_values(rules);
  world.signals.resize(rules.signals.size());
  // l_enter of the initial states; user code is not called, its memory is zero after a reset.
  for (const UnitRules& unit : rules.units) {
    if (!rules.fault.empty()) break;
    for (const auto& [event, on] : unit.states[unit.initial].enter) {
      write_event(rules, world, unit.events[event], on ? 1 : 0);
    }
  }
  return world;
}

}  // namespace symplant::reference
