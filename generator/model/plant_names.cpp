// Looks up the names in conditions.
#include "model/plant_names.hpp"

namespace symplant::model {
namespace {

std::optional<std::uint32_t> find(const auto& map, std::string_view name) {
  const auto found = map.find(name);
  if (found == map.end()) return std::nullopt;
  return found->second;
}

}  // namespace

PlantNames::PlantNames(const PlantModel& plant, const description::Faults& faults) : plant_(plant), faults_(faults) {
  units_.reserve(plant.units.size());
  for (std::uint32_t i = 0; i < plant.units.size(); ++i) {
    const Unit& unit = plant.units[i];
    units_.try_emplace(unit.path, i);
    if (unit.facet != nullptr && !unit.facet->name.empty()) facets_[unit.facet->path].push_back(i);
  }
  symbols_.reserve(plant.symbols.size());
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) symbols_.try_emplace(plant.symbols[i].name(), i);
  const Material& material = plant.material;
  for (std::uint32_t i = 0; i < material.locations(); ++i) {
    locations_.try_emplace(material.location_name(i), i);
  }
  for (std::uint32_t i = 0; i < material.kinds.size(); ++i) part_kinds_.try_emplace(material.kinds[i].name, i);
  for (std::uint32_t i = 0; i < plant.values.size(); ++i) values_.try_emplace(plant.values[i].name, i);
}

std::optional<std::uint32_t> PlantNames::unit(std::string_view device, std::string_view facet) const {
  if (facet.empty()) return find(units_, device);
  if (facets_.empty()) return std::nullopt;
  return find(units_, std::string(device).append(".").append(facet));
}

std::vector<std::uint32_t> PlantNames::facets(std::string_view device) const {
  const auto found = facets_.find(device);
  return found == facets_.end() ? std::vector<std::uint32_t>() : found->second;
}

std::string PlantNames::path(std::uint32_t unit) const { return std::string(plant_.units[unit].path); }

std::optional<std::uint8_t> PlantNames::state(std::uint32_t unit, std::string_view name) const {
  const std::vector<State>& states = plant_.units[unit].states;
  for (std::size_t s = 0; s < states.size(); ++s) {
    if (text::equal_ignoring_case(states[s].name, name)) return static_cast<std::uint8_t>(s);
  }
  return std::nullopt;
}

std::optional<condition::Names::Symbol> PlantNames::symbol(std::string_view name) const {
  const auto found = find(symbols_, name);
  if (!found) return std::nullopt;
  return Symbol{*found, plant_.symbols[*found].type};
}

std::optional<std::uint32_t> PlantNames::location(std::string_view name) const { return find(locations_, name); }

std::optional<std::uint32_t> PlantNames::part_kind(std::string_view name) const { return find(part_kinds_, name); }

std::optional<condition::Names::Value> PlantNames::value(std::string_view name) const {
  const auto found = find(values_, name);
  if (!found) return std::nullopt;
  const tables::ValueRow& row = plant_.values[*found].row;
  return Value{row.output, row.outputs};
}

std::string PlantNames::nearest_value(std::string_view name) const {
  return std::string(faults_.nearest(name, plant_.values.size(),
                                     [&](std::size_t i) -> std::string_view { return plant_.values[i].name; }));
}

std::string PlantNames::nearest_part_kind(std::string_view name) const {
  const std::vector<PartKind>& kinds = plant_.material.kinds;
  return std::string(
      faults_.nearest(name, kinds.size(), [&](std::size_t i) -> std::string_view { return kinds[i].name; }));
}

std::string PlantNames::nearest_device(std::string_view device, std::string_view facet) const {
  if (!facet.empty() && facets_.empty()) return {};
  const std::string wanted = facet.empty() ? std::string(device) : std::string(device).append(".").append(facet);
  const std::size_t units = plant_.units.size();
  const std::size_t locations = plant_.material.locations();
  return std::string(faults_.nearest(wanted, units + locations, [&](std::size_t i) -> std::string_view {
    return i < units ? plant_.units[i].path : plant_.material.location_name(static_cast<std::uint32_t>(i - units));
  }));
}

std::string PlantNames::nearest_state(std::uint32_t unit, std::string_view name) const {
  const std::vector<State>& states = plant_.units[unit].states;
  return std::string(
      faults_.nearest(name, states.size(), [&](std::size_t s) -> std::string_view { return states[s].name; }));
}

std::string PlantNames::nearest_symbol(std::string_view name) const {
  return std::string(
      faults_.nearest(name, plant_.symbols.size(), [&](std::size_t i) { return plant_.symbols[i].name(); }));
}

std::string PlantNames::why_no_state(std::uint32_t unit, std::string_view name) const {
  const Unit& of = plant_.units[unit];
  const auto reports = [&](const std::vector<std::uint32_t>& side, std::string_view why) -> std::string {
    for (const std::uint32_t symbol : side) {
      if (!text::equal_ignoring_case(plant_.symbols[symbol].reading.task(), name)) continue;
      return description::ticked(name) + std::string(why) + description::ticked(of.path) + "; name the symbol " +
             description::ticked(plant_.symbols[symbol].name());
    }
    return {};
  };
  std::string why = reports(of.operations, " only commands given transitions and is not a state of ");
  if (why.empty()) why = reports(of.events, " is only switched by `outputs` and is not a state of ");
  return why;
}

}  // namespace symplant::model
