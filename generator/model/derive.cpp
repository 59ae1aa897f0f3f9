// The two stages of the derivation.
#include "model/derive.hpp"

#include <utility>

#include "base/index_table.hpp"
#include "base/large_memory.hpp"
#include "model/collect_symbols.hpp"
#include "model/derive_unit.hpp"
#include "model/layout.hpp"
#include "model/links.hpp"
#include "model/made_transitions.hpp"
#include "model/match_entries.hpp"
#include "model/material/entries.hpp"
#include "model/material/resolve.hpp"
#include "model/pair_units.hpp"
#include "model/relations.hpp"
#include "model/resolve_malfunctions.hpp"
#include "model/shared_addresses.hpp"
#include "model/states.hpp"
#include "model/symbol_settings.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

constexpr std::size_t kFew = 6;  ///< as many as fit in the smallest allocation

/// Adds every BOOL symbol whose name follows the rule to the unit of its device.
void gather_units(PlantModel& plant) {
  base::IndexTable by_path(plant.symbols.size() / 4);
  base::reserve_large(plant.units, plant.symbols.size() / 4);
  std::uint32_t last = kNone;  // rows of one device are mostly adjacent
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    Symbol& symbol = plant.symbols[i];
    if (symbol.driven_without_unit()) continue;
    if (symbol.type != tables::DataType::boolean) {
      symbol.unmodelled = Unmodelled::numeric;
      continue;
    }
    if (symbol.reading.fault != name::NameFault::none) {
      symbol.unmodelled = Unmodelled::name;
      continue;
    }
    const std::string_view path = symbol.reading.device_path();
    if (last == kNone || plant.units[last].path != path) {
      const auto next = static_cast<std::uint32_t>(plant.units.size());
      last = by_path.find_or_add(text::hash_ignoring_case(path), next, [&](std::uint32_t unit) {
        return text::equal_ignoring_case(plant.units[unit].path, path);
      });
      if (last == next) {
        Unit& unit = plant.units.emplace_back();
        unit.path = path;
        unit.device = symbol.reading.device();
        unit.operations.reserve(kFew);
        unit.events.reserve(kFew);
      }
    }
    Unit& unit = plant.units[last];
    symbol.unit = last;
    (symbol.direction == tables::Direction::operation ? unit.operations : unit.events).push_back(i);
  }
}

/// Of several symbols with one task and direction only the first is kept.
void drop_taken_tasks(std::vector<std::uint32_t>& side, std::vector<Symbol>& symbols) {
  if (side.size() < 2) return;
  const auto taken = [&](std::size_t index) {
    for (std::size_t i = 0; i < index; ++i) {
      if (text::equal_ignoring_case(symbols[side[i]].reading.task(), symbols[side[index]].reading.task())) return true;
    }
    return false;
  };
  const auto drop = [&](std::uint32_t symbol) {
    symbols[symbol].unmodelled = Unmodelled::task_taken;
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
  TooLarge large{unit.path, unit.operations, unit.operations.size(), unit.events.size(), states};
  large.symbols.insert(large.symbols.end(), unit.events.begin(), unit.events.end());
  for (const std::uint32_t symbol : large.symbols) {
    plant.symbols[symbol].unmodelled = Unmodelled::unit_too_large;
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
      plant.units[kept] = std::move(unit);
    }
    ++kept;
  }
  plant.units.resize(kept);
  if (!later) return;
  resolve_material(derived, made, faults);
  leave_out_unknown(plant, made, faults);
  for (std::size_t i = 0; i < plant.units.size(); ++i) {
    derive_transitions(plant.units[i], plant.symbols, plant.description->defaults, derived.evidence.units[i], faults);
  }
}

void group_symbols(Derived& derived, const std::vector<const name::RuleReading*>& readings) {
  derived.plant.reader != nullptr ? pair_units(derived, readings) : gather_units(derived.plant);
}

/// Makes the entries of the material flow and marks the symbols of their sensors, before the symbols are grouped.
void prepare_material(Derived& derived, const description::GivenMaterial& given,
                      const std::vector<const name::RuleReading*>& readings) {
  description::Faults faults(derived.evidence.faults, derived.evidence.warnings);
  PlantModel& plant = derived.plant;
  if (for_devices(given)) {  // of which sensors may be a part
    const std::vector<Symbol> ungrouped = plant.symbols;
    const auto levels = plant.levels == nullptr ? std::vector<name::LevelTexts>() : *plant.levels;
    group_symbols(derived, readings);
    derived.material = make_material(plant, given, faults);
    plant.units.clear();
    plant.symbols = ungrouped;
    if (plant.levels != nullptr) *plant.levels = levels;
  } else {
    derived.material = make_material(plant, given, faults);
  }
  mark_sensors(plant, derived.material, faults);
}

}  // namespace

Derived derive(const std::vector<ListInput>& lists, std::string plant_name,
               std::shared_ptr<const name::SymbolReader> reader, const description::Description* description) {
  Derived derived;
  derived.plant.name = std::move(plant_name);
  derived.plant.rule = lists.front().named.rule;
  derived.plant.reader = std::move(reader);
  const std::vector<const name::RuleReading*> readings = collect_symbols(derived, lists);
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
                 std::shared_ptr<const text::SourceFile> source) {
  PlantModel& plant = derived.plant;
  Evidence& evidence = derived.evidence;
  plant.description =
      description != nullptr ? std::move(description) : std::make_shared<const description::Description>();
  plant.description_source = std::move(source);
  description::Faults faults(evidence.faults, evidence.warnings);
  const std::vector<const description::LinkDescription*> links = check_links(plant, faults);
  evidence.decisions = match_entries(plant, faults);
  MadeNames made;
  derive_units(derived, made, faults);
  add_relations(plant, made, faults);
  report_made_names(plant, made, faults);
  report_lacks(plant, faults);
  evidence.driven_twice = find_shared_addresses(plant);
  resolve_malfunctions(plant, faults);
  resolve_links(plant, links, faults);
  check_view(plant, faults);
  return derived;
}

}  // namespace symplant::model
