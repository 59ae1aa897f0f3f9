// The two stages of the derivation.
#include "model/derive.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/large_memory.hpp"
#include "elements/alarm/resolve.hpp"
#include "elements/follow/resolve.hpp"
#include "elements/link/resolve.hpp"
#include "elements/malfunction/resolve.hpp"
#include "elements/material/entries.hpp"
#include "elements/material/resolve.hpp"
#include "elements/requirement/resolve.hpp"
#include "elements/scene/resolve.hpp"
#include "elements/signal/resolve.hpp"
#include "elements/times/resolve.hpp"
#include "elements/value/resolve.hpp"
#include "model/collect_symbols.hpp"
#include "model/condition_reader.hpp"
#include "model/derive_unit.hpp"
#include "model/group_symbols.hpp"
#include "model/layout.hpp"
#include "model/made_transitions.hpp"
#include "model/match_entries.hpp"
#include "model/relations.hpp"
#include "model/shared_addresses.hpp"
#include "model/states.hpp"
#include "model/symbol_settings.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

/// Keeps the first of several symbols with one task.
void keep_first_of_task(std::vector<std::uint32_t>& side, std::vector<Symbol>& symbols) {
  const auto taken = [&](std::size_t index) {
    for (std::size_t i = 0; i < index; ++i) {
      if (text::equal_ignoring_case(symbols[side[i]].reading.task(), symbols[side[index]].reading.task())) return true;
    }
    return false;
  };
  const auto drop = [&](std::uint32_t symbol) {
    symbols[symbol].account = Account::task_taken;
    symbols[symbol].unit = kNone;
  };
  if (side.size() <= 16) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < side.size(); ++i) {
      side[kept] = side[i];
      if (taken(kept)) {
        drop(side[i]);
      } else {
        ++kept;
      }
    }
    side.resize(kept);
    return;
  }
  text::ByName<bool> tasks;
  std::erase_if(side, [&](std::uint32_t symbol) {
    if (tasks.try_emplace(symbols[symbol].reading.task(), true).second) return false;
    drop(symbol);
    return true;
  });
}

/// Of several symbols with one task and direction only the first is kept. What the description gives comes first.
void drop_taken_tasks(std::vector<std::uint32_t>& side, std::vector<Symbol>& symbols) {
  if (side.size() < 2) return;
  const auto is_described = [&](std::uint32_t symbol) { return symbols[symbol].described; };
  if (std::any_of(side.begin(), side.end(), is_described)) {
    std::stable_partition(side.begin(), side.end(), is_described);
    keep_first_of_task(side, symbols);
    std::sort(side.begin(), side.end());
  } else {
    keep_first_of_task(side, symbols);
  }
}

/// False if the unit exceeds the limits; then its symbols become unmodelled.
bool within_limits(Unit& unit, Derived& derived, description::Faults& faults) {
  PlantModel& plant = derived.plant;
  const std::size_t symbols = unit.operations.size() + unit.events.size();
  if (unit.operations.size() <= tables::kMaxOperations && unit.events.size() <= tables::kMaxEvents &&
      symbols <= tables::kMaxStates) {
    return true;  // without counting states: each has a symbol
  }
  const std::size_t states = states_of(unit, plant.symbols, TaskRoles(unit, plant.symbols)).size();
  if (unit.operations.size() <= tables::kMaxOperations && unit.events.size() <= tables::kMaxEvents &&
      states <= tables::kMaxStates) {
    return true;
  }
  for (const std::uint32_t symbol : unit.values) plant.symbols[symbol].value_of = kNone;
  TooLarge large{unit.path, unit.operations, unit.operations.size(), unit.events.size(), states};
  large.symbols.insert(large.symbols.end(), unit.events.begin(), unit.events.end());
  for (const std::uint32_t symbol : large.symbols) {
    plant.symbols[symbol].account = Account::unit_too_large;
    plant.symbols[symbol].unit = kNone;
  }
  derived.evidence.too_large.push_back(std::move(large));
  if (unit.described != nullptr && !unit.described->is_pattern()) {
    faults.add(description::device_pointer(*unit.described),
               description::ticked(unit.path) +
                   " has too many symbols for a device and is not modelled; remove its description");
  }
  return false;
}

void derive_units(Derived& derived, MadeNames& made, description::Faults& faults) {
  PlantModel& plant = derived.plant;
  // Which transitions there are depends on all states, and on the names of tracks and places.
  const bool later = makes_names(*plant.description) || !plant.description->material.empty();
  base::reserve_large(derived.evidence.units, plant.units.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < plant.units.size(); ++i) {
    Unit& unit = plant.units[i];
    drop_taken_tasks(unit.operations, plant.symbols);
    drop_taken_tasks(unit.events, plant.symbols);
    if (!within_limits(unit, derived, faults)) continue;
    if (unit.described != nullptr) faults.describes(*unit.described);
    UnitEvidence evidence = derive_states(unit, plant.symbols, plant.description->defaults, faults);
    if (!later) derive_transitions(unit, plant.symbols, plant.description->defaults, evidence, faults);
    derived.evidence.units.push_back(std::move(evidence));
    if (kept != i) {
      for (const auto* side : {&unit.operations, &unit.events}) {
        for (const std::uint32_t symbol : *side) plant.symbols[symbol].unit = static_cast<std::uint32_t>(kept);
      }
      for (const std::uint32_t symbol : unit.values) plant.symbols[symbol].value_of = static_cast<std::uint32_t>(kept);
      plant.units[kept] = std::move(unit);
    }
    ++kept;
  }
  plant.units.resize(kept);
  name_values(plant, faults);
  if (!later) return;
  resolve_material(derived, made, faults);
  leave_out_unknown(plant, made, faults);
  for (std::size_t i = 0; i < plant.units.size(); ++i) {
    derive_transitions(plant.units[i], plant.symbols, plant.description->defaults, derived.evidence.units[i], faults);
  }
}

/// Makes the entries of the material flow and marks the symbols of their sensors, before the symbols are grouped.
void prepare_material(Derived& derived, const description::GivenMaterial& given,
                      const std::vector<const name::Reading*>& readings) {
  description::Faults faults(derived.evidence.faults, derived.evidence.warnings);
  PlantModel& plant = derived.plant;
  if (for_devices(given)) {  // of which sensors may be a part
    const std::vector<Symbol> ungrouped = plant.symbols;
    group_symbols(derived, readings);
    derived.material = make_material(plant, given, faults);
    plant.units.clear();
    plant.symbols = ungrouped;
  } else {
    derived.material = make_material(plant, given, faults);
  }
  mark_sensors(plant, derived.material, faults);
}

/// Resolves all that conditions of the description say, and sets times. Adds to the `decisions` for --verbose.
void resolve_conditions(PlantModel& plant, MadeNames& made, std::vector<std::string>& decisions,
                        description::Faults& faults) {
  const bool described = !plant.description->devices.empty() || plant.pairing != nullptr;
  if (!described && plant.description->requirements.empty() && plant.follows.empty() && plant.values.empty() &&
      plant.signals.empty() && plant.description->times.empty()) {
    return;
  }
  ConditionReader conditions(plant, faults);
  TimeFormulas times(plant, conditions, made);
  add_relations(plant, conditions, times, made, faults);
  std::vector<std::string> timed = resolve_times(plant, times, made, faults);
  std::move(timed.begin(), timed.end(), std::back_inserter(decisions));
  resolve_requirements(plant, conditions, made, faults);
  resolve_follows(plant, conditions, made, faults);
  resolve_values(plant, conditions, made, faults);
  resolve_signals(plant, conditions, made, faults);
}

}  // namespace

Derived derive(const std::vector<ListInput>& lists, std::string plant_name,
               std::shared_ptr<const name::SymbolReader> reader, const description::Description* description) {
  Derived derived;
  derived.plant.name = std::move(plant_name);
  derived.plant.reader = std::move(reader);
  const std::vector<const name::Reading*> readings = collect_symbols(derived, lists);
  if (description != nullptr) {
    description::Faults faults(derived.evidence.faults, derived.evidence.warnings);
    apply_symbol_settings(derived.plant, *description, faults);
  }
  if (description != nullptr && !description->material.empty()) {
    prepare_material(derived, description->material, readings);
  }
  group_symbols(derived, readings);
  return derived;
}

Derived describe(Derived derived, std::shared_ptr<const description::Description> description,
                 std::shared_ptr<const description::PlantSource> source, std::vector<std::string> naming_files) {
  PlantModel& plant = derived.plant;
  plant.naming_files = std::move(naming_files);
  Evidence& evidence = derived.evidence;
  plant.description =
      description != nullptr ? std::move(description) : std::make_shared<const description::Description>();
  plant.description_source = std::move(source);
  description::Faults faults(evidence.faults, evidence.warnings);
  const std::vector<const description::LinkDescription*> links = check_links(plant, faults);
  check_programs(plant, faults);
  evidence.decisions = match_entries(plant, faults);
  MadeNames made;
  derive_units(derived, made, faults);
  resolve_conditions(plant, made, evidence.decisions, faults);
  report_made_names(plant, made, faults);
  report_lacks(plant, faults);
  evidence.driven_twice = find_shared_addresses(plant);
  resolve_malfunctions(plant, faults);
  resolve_alarms(plant, faults);
  resolve_links(plant, links, faults);
  check_view(plant, faults);
  check_scene(plant, faults);
  return derived;
}

}  // namespace symplant::model
