// Groups symbols by the facets that a custom naming rule makes of them.
#include "model/pair_units.hpp"

#include <cstdint>
#include <utility>

#include "base/large_memory.hpp"

namespace symplant::model {
namespace {

Unmodelled reason_of(pairing::Account account, const Symbol& symbol) {
  switch (account) {
    case pairing::Account::paired:
      return Unmodelled::modelled;
    case pairing::Account::constant:
      return Unmodelled::constant;
    case pairing::Account::operator_panel:
      return Unmodelled::operator_panel;
    case pairing::Account::data:
      return symbol.type == tables::DataType::boolean ? Unmodelled::data : Unmodelled::numeric;
    case pairing::Account::none:
      return Unmodelled::role_none;
    case pairing::Account::unpaired:
      return Unmodelled::unpaired;
    case pairing::Account::ignored:
      return Unmodelled::ignored;
    case pairing::Account::no_rule:
    case pairing::Account::no_direction:
      return Unmodelled::no_rule;
    case pairing::Account::internal:
      return Unmodelled::named_internal;
  }
  return Unmodelled::no_rule;
}

/// `ignored` is the reading of all symbols that a condition or parts drive.
std::vector<pairing::Input> inputs_of(const PlantModel& plant, const std::vector<const name::RuleReading*>& readings,
                                      const name::RuleReading& ignored) {
  std::vector<pairing::Input> inputs;
  base::reserve_large(inputs, plant.symbols.size());
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const Symbol& symbol = plant.symbols[i];
    const bool operation = symbol.direction == tables::Direction::operation;
    const bool driven = symbol.driven_without_unit();
    inputs.push_back({driven ? &ignored : readings[i], driven ? std::string_view() : symbol.name(),
                      operation ? name::Side::operation : name::Side::event, symbol.type == tables::DataType::boolean,
                      plant.controller_of(symbol)});
  }
  return inputs;
}

void add_unit(PlantModel& plant, const pairing::Facet& facet) {
  const auto index = static_cast<std::uint32_t>(plant.units.size());
  Unit& unit = plant.units.emplace_back();
  unit.path = facet.unit_path();
  unit.device = facet.device;
  unit.facet = &facet;
  for (const pairing::Member& member : facet.members) {
    Symbol& symbol = plant.symbols[member.input];
    symbol.unit = index;
    name::LevelTexts& levels = (*plant.levels)[member.input];
    levels = {facet.path, facet.line, facet.process, facet.device, member.task};
    symbol.reading = name::NameReading::of(levels, name::NameFault::none, symbol.reading.direction);
    (symbol.direction == tables::Direction::operation ? unit.operations : unit.events).push_back(member.input);
  }
}

}  // namespace

void pair_units(Derived& derived, const std::vector<const name::RuleReading*>& readings) {
  PlantModel& plant = derived.plant;
  name::RuleReading ignored;
  ignored.outcome = name::Outcome::ignored;
  plant.pairing = std::make_shared<const pairing::Pairing>(
      pairing::pair(plant.reader->naming(), inputs_of(plant, readings, ignored)));
  base::reserve_large(plant.units, plant.pairing->facets.size());
  for (const pairing::Facet& facet : plant.pairing->facets) add_unit(plant, facet);
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    Symbol& symbol = plant.symbols[i];
    if (symbol.driven_without_unit()) continue;
    const pairing::Account account = plant.pairing->accounts[i];
    symbol.unmodelled = reason_of(account, symbol);
    if (account == pairing::Account::constant) symbol.initial = plant.pairing->constant_on[i] ? 1 : 0;
  }
}

}  // namespace symplant::model
