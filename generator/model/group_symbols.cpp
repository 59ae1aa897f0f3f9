// Groups symbols into units.
#include "model/group_symbols.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/large_memory.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

constexpr std::size_t kFew = 6;  ///< as many as fit in the smallest allocation

/// The unit of a device, which is added with its first symbol.
std::uint32_t unit_of(PlantModel& plant, const SymbolReading& reading, std::vector<std::uint32_t>& units) {
  std::uint32_t& index = units[reading.levels()->device_id];
  if (index != kNone) return index;
  index = static_cast<std::uint32_t>(plant.units.size());
  Unit& unit = plant.units.emplace_back();
  unit.path = reading.device_path();
  unit.device = reading.device();
  unit.operations.reserve(kFew);
  unit.events.reserve(kFew);
  return index;
}

std::size_t number_of_devices(const PlantModel& plant) {
  return plant.reader->devices() + (plant.described_levels == nullptr ? 0 : plant.described_levels->size());
}

/// Adds a symbol to its unit.
void add_symbol(PlantModel& plant, std::uint32_t index, std::uint32_t unit_index) {
  Symbol& symbol = plant.symbols[index];
  Unit& unit = plant.units[unit_index];
  if (symbol.type != tables::DataType::boolean) {
    symbol.account = Account::numeric;
    symbol.value_of = unit_index;
    unit.values.push_back(index);
    return;
  }
  symbol.unit = unit_index;
  (symbol.direction == tables::Direction::operation ? unit.operations : unit.events).push_back(index);
}

/// Each device is one unit.
void group_by_device(PlantModel& plant) {
  base::reserve_large(plant.units, plant.symbols.size() / 4);
  std::vector<std::uint32_t> units(number_of_devices(plant), kNone);
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const Symbol& symbol = plant.symbols[i];
    if (symbol.account == Account::modelled) add_symbol(plant, i, unit_of(plant, symbol.reading, units));
  }
}

/// Adds the symbols that the description gives a device to its unit, which may be new, and sorts the units again.
void add_described(PlantModel& plant) {
  if (plant.described_levels == nullptr) return;
  text::ByName<std::uint32_t> by_path;
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) by_path.try_emplace(plant.units[u].path, u);
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const SymbolReading reading = plant.symbols[i].reading;
    if (!plant.symbols[i].described) continue;
    const auto next = static_cast<std::uint32_t>(plant.units.size());
    const auto [found, added] = by_path.try_emplace(reading.device_path(), next);
    if (added) {
      Unit& unit = plant.units.emplace_back();
      unit.path = reading.device_path();
      unit.device = reading.device();
    }
    add_symbol(plant, i, found->second);
  }
  for (Unit& unit : plant.units) {
    for (auto* side : {&unit.operations, &unit.events, &unit.values}) std::sort(side->begin(), side->end());
  }
  std::stable_sort(plant.units.begin(), plant.units.end(),
                   [](const Unit& a, const Unit& b) { return a.first_symbol() < b.first_symbol(); });
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    const Unit& unit = plant.units[u];
    for (const auto* side : {&unit.operations, &unit.events}) {
      for (const std::uint32_t symbol : *side) plant.symbols[symbol].unit = u;
    }
    for (const std::uint32_t symbol : unit.values) plant.symbols[symbol].value_of = u;
  }
}

/// `driven` is the reading of all symbols for which the naming rule has no say.
std::vector<pairing::Input> inputs_of(const PlantModel& plant, const std::vector<const name::Reading*>& readings,
                                      const name::Reading& driven) {
  std::vector<pairing::Input> inputs;
  base::reserve_large(inputs, plant.symbols.size());
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const Symbol& symbol = plant.symbols[i];
    const bool given = symbol.is_given();
    inputs.push_back({given ? &driven : readings[i], given ? std::string_view() : symbol.name(), symbol.direction,
                      symbol.type == tables::DataType::boolean, plant.controller_of(symbol)});
  }
  return inputs;
}

void add_unit(PlantModel& plant, const pairing::Facet& facet) {
  const auto index = static_cast<std::uint32_t>(plant.units.size());
  const name::DeviceLevels& levels =
      plant.facet_levels->emplace_back(name::DeviceLevels{facet.path, facet.line, facet.process, facet.device, 0, 0});
  Unit& unit = plant.units.emplace_back();
  unit.path = facet.unit_path();
  unit.device = facet.device;
  unit.facet = &facet;
  unit.values = facet.numbers;
  for (const std::uint32_t number : unit.values) plant.symbols[number].value_of = index;
  for (const pairing::Member& member : facet.members) {
    Symbol& symbol = plant.symbols[member.input];
    symbol.unit = index;
    symbol.account = Account::modelled;
    symbol.reading = {&levels, member.task};
    (symbol.direction == tables::Direction::operation ? unit.operations : unit.events).push_back(member.input);
    if (!member.makes_state) unit.reports.push_back(member.input);
  }
}

/// The facets of a device are its units.
void group_by_facet(PlantModel& plant, const std::vector<const name::Reading*>& readings) {
  name::Reading driven;
  driven.account = Account::ignored;
  plant.pairing = std::make_shared<const pairing::Pairing>(
      pairing::pair(plant.reader->naming(), inputs_of(plant, readings, driven), pairing::Extent::devices));
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    Symbol& symbol = plant.symbols[i];
    if (symbol.is_given()) continue;
    symbol.account = plant.pairing->accounts[i];
    if (symbol.account == Account::constant) symbol.initial = plant.pairing->constant_on[i] ? 1 : 0;
  }
  const std::vector<pairing::Facet>& facets = plant.pairing->facets;
  plant.facet_levels = std::make_shared<std::vector<name::DeviceLevels>>();
  plant.facet_levels->reserve(facets.size());  // symbols point to them
  base::reserve_large(plant.units, facets.size());
  for (const pairing::Facet& facet : facets) add_unit(plant, facet);
}

}  // namespace

void group_symbols(Derived& derived, const std::vector<const name::Reading*>& readings) {
  PlantModel& plant = derived.plant;
  if (plant.naming().units == name::Units::device) {
    group_by_device(plant);
  } else {
    group_by_facet(plant, readings);
    add_described(plant);
  }
}

}  // namespace symplant::model
