// Looks up units, states and symbols of a plant's tables by name.
#include "symplant/scenario/table_names.hpp"

#include <utility>

#include "symplant/tables/ascii.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::scenario {
namespace {

std::string path_of(std::string_view device, std::string_view facet) {
  std::string text(device);
  return facet.empty() ? text : text.append(".").append(facet);
}

}  // namespace

TableNames::TableNames(const trace::PlantNames& names) : names_(names) {
  const tables::PlantTables& tables = names.tables();
  units_.reserve(tables.units.size());
  for (std::uint32_t u = 0; u < tables.units.size(); ++u) {
    std::string name = tables::to_upper(names.unit(u));
    const std::size_t dot = name.rfind('.');
    if (dot != std::string::npos) facets_[name.substr(0, dot)].push_back(u);
    units_.try_emplace(std::move(name), u);
  }
  symbols_.reserve(tables.symbols.size());
  for (std::uint32_t s = 0; s < tables.symbols.size(); ++s) symbols_.try_emplace(tables::to_upper(names.symbol(s)), s);
  for (std::uint32_t i = 0; i < tables.material.locations(); ++i) {
    locations_.try_emplace(tables::to_upper(names.location(i)), i);
  }
  for (std::uint32_t i = 0; i < tables.material.kinds.size(); ++i) {
    part_kinds_.try_emplace(tables::to_upper(names.part_kind(i)), i);
  }
  for (std::uint32_t i = 0; i < tables.malfunctions.size(); ++i) {
    malfunctions_.try_emplace(tables::to_upper(names.malfunction(i)), i);
  }
  for (std::uint32_t v = 0; v < tables.values.rows.size(); ++v) {
    values_.try_emplace(tables::to_upper(names.value(v)), v);
  }
}

std::optional<std::uint32_t> TableNames::value_index(std::string_view name) const {
  const auto found = values_.find(tables::to_upper(name));
  return found == values_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<condition::Names::Value> TableNames::value(std::string_view name) const {
  const auto found = value_index(name);
  if (!found) return std::nullopt;
  const tables::ValueRow& row = names_.tables().values.rows[*found];
  return Value{row.output, row.outputs};
}

std::string TableNames::nearest_value(std::string_view name) const {
  tables::NearestName nearest(name);
  for (std::uint32_t v = 0; v < names_.tables().values.rows.size(); ++v) nearest.offer(names_.value(v));
  return std::string(nearest.name());
}

std::optional<std::uint32_t> TableNames::location(std::string_view name) const {
  const auto found = locations_.find(tables::to_upper(name));
  return found == locations_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::uint32_t> TableNames::part_kind(std::string_view name) const {
  const auto found = part_kinds_.find(tables::to_upper(name));
  return found == part_kinds_.end() ? std::nullopt : std::optional(found->second);
}

std::string TableNames::nearest_part_kind(std::string_view name) const {
  tables::NearestName nearest(name);
  for (std::uint32_t i = 0; i < names_.tables().material.kinds.size(); ++i) nearest.offer(names_.part_kind(i));
  return std::string(nearest.name());
}

std::string TableNames::nearest_location(std::string_view name) const {
  tables::NearestName nearest(name);
  for (std::uint32_t i = 0; i < names_.tables().material.locations(); ++i) nearest.offer(names_.location(i));
  return std::string(nearest.name());
}

std::optional<std::uint32_t> TableNames::unit(std::string_view device, std::string_view facet) const {
  const auto found = units_.find(tables::to_upper(path_of(device, facet)));
  if (found == units_.end()) return std::nullopt;
  return found->second;
}

std::vector<std::uint32_t> TableNames::facets(std::string_view device) const {
  const auto found = facets_.find(tables::to_upper(device));
  return found == facets_.end() ? std::vector<std::uint32_t>() : found->second;
}

std::string TableNames::path(std::uint32_t unit) const { return std::string(names_.unit(unit)); }

std::optional<std::uint8_t> TableNames::state(std::uint32_t unit, std::string_view name) const {
  const auto states = names_.states(unit);
  const std::string wanted = tables::to_upper(name);
  for (std::size_t s = 0; s < states.size(); ++s) {
    if (states[s].size() == name.size() && tables::to_upper(states[s]) == wanted) return static_cast<std::uint8_t>(s);
  }
  return std::nullopt;
}

std::optional<condition::Names::Symbol> TableNames::symbol(std::string_view name) const {
  const auto found = symbols_.find(tables::to_upper(name));
  if (found == symbols_.end()) return std::nullopt;
  return Symbol{found->second, names_.tables().symbols[found->second].type()};
}

std::string TableNames::nearest_device(std::string_view device, std::string_view facet) const {
  const std::string wanted = path_of(device, facet);
  tables::NearestName nearest(wanted);
  for (std::uint32_t u = 0; u < names_.tables().units.size(); ++u) nearest.offer(names_.unit(u));
  for (std::uint32_t i = 0; i < names_.tables().material.locations(); ++i) nearest.offer(names_.location(i));
  return std::string(nearest.name());
}

std::string TableNames::nearest_state(std::uint32_t unit, std::string_view name) const {
  tables::NearestName nearest(name);
  for (const std::string_view state : names_.states(unit)) nearest.offer(state);
  return std::string(nearest.name());
}

std::string TableNames::nearest_symbol(std::string_view name) const {
  tables::NearestName nearest(name);
  for (std::uint32_t s = 0; s < names_.tables().symbols.size(); ++s) nearest.offer(names_.symbol(s));
  return std::string(nearest.name());
}

std::string TableNames::why_no_state(std::uint32_t unit, std::string_view name) const {
  const std::string wanted = tables::to_upper(name);
  for (const std::uint32_t symbol : names_.symbols_of(unit)) {
    if (tables::to_upper(names_.task(symbol)) != wanted) continue;
    return "`" + std::string(name) + "` is not a state of `" + std::string(names_.unit(unit)) + "`; name the symbol `" +
           std::string(names_.symbol(symbol)) + "`";
  }
  return {};
}

}  // namespace symplant::scenario
