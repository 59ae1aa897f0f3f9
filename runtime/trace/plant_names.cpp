// The names of symbols, units, states, requirements, lists and links.
#include "symplant/trace/plant_names.hpp"

#include "symplant/tables/lists.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::trace {

PlantNames::PlantNames(const tables::PlantTables& tables)
    : tables_(tables),
      symbols_(tables.symbol_names),
      units_(tables.unit_names),
      states_(tables::split_names(tables.state_names)),
      requirements_(tables::split_names(tables.requirement_names)),
      lists_(tables::split_names(tables.list_names)),
      locations_(tables::split_names(tables.material.location_names)),
      part_kinds_(tables::split_names(tables.material.kind_names)),
      transfers_(tables::split_names(tables.material.transfer_names)),
      work_(tables::split_names(tables.material.work_names)),
      sources_(tables::split_names(tables.material.source_names)),
      malfunctions_(tables::split_names(tables.malfunctions.names)),
      values_(tables::split_names(tables.values.names)) {
  first_states_.reserve(tables.types.size());
  std::uint32_t states = 0;
  for (const tables::TypeRow& type : tables.types) {
    first_states_.push_back(states);
    states += type.states;
  }
  states_.resize(states);
}

void PlantNames::group() const {
  first_of_.resize(tables_.units.size() + 1);
  for (const tables::SymbolRow& symbol : tables_.symbols) {
    if (symbol.unit != tables::kNone) ++first_of_[symbol.unit + 1];
  }
  for (std::size_t u = 1; u < first_of_.size(); ++u) first_of_[u] += first_of_[u - 1];
  by_unit_.resize(first_of_.back());
  std::vector<std::uint32_t> at(first_of_.begin(), first_of_.end() - 1);
  for (std::uint32_t s = 0; s < tables_.symbols.size(); ++s) {
    const std::uint32_t unit = tables_.symbols[s].unit;
    if (unit != tables::kNone) by_unit_[at[unit]++] = s;
  }
}

std::span<const std::string_view> PlantNames::states(std::uint32_t unit) const {
  const std::uint32_t type = tables_.units[unit].type;
  return std::span(states_).subspan(first_states_[type], tables_.types[type].states);
}

std::string_view PlantNames::state(std::uint32_t unit, std::uint8_t state) const { return states(unit)[state]; }

std::string_view PlantNames::loop_member(std::uint32_t of) const {
  std::size_t rest = of;
  const auto within = [&rest](std::size_t size) {
    if (rest < size) return true;
    rest -= size;
    return false;
  };
  if (within(tables_.units.size())) return unit(of);
  if (within(tables_.follows.size())) return symbol(tables_.follows[rest].symbol);
  if (within(tables_.material.tracks.size())) return locations_[rest];
  if (within(transfers_.size())) return transfers_[rest];
  if (within(work_.size())) return work_[rest];
  if (within(sources_.size())) return sources_[rest];
  return within(malfunctions_.size()) ? malfunctions_[rest] : value(static_cast<std::uint32_t>(rest));
}

std::uint32_t PlantNames::value_of(std::uint32_t output) const {
  const auto& rows = tables_.values.rows;
  const auto after = std::upper_bound(rows.begin(), rows.end(), output,
                                      [](std::uint32_t of, const tables::ValueRow& row) { return of < row.output; });
  return static_cast<std::uint32_t>(after - rows.begin()) - 1;
}

std::string PlantNames::output(std::uint32_t output) const {
  const std::uint32_t v = value_of(output);
  const tables::ValueRow& row = tables_.values.rows[v];
  std::string name(value(v));
  return row.outputs == 1 ? name : name + "[" + std::to_string(output - row.output + 1) + "]";
}

std::string PlantNames::malfunction(std::uint32_t number) const {
  const tables::MalfunctionNumbers numbers(tables_);
  if (numbers.is_written(number)) return std::string(malfunctions_[number]);
  const std::string_view of = numbers.is_of_unit(number) ? unit(numbers.unit(number)) : symbol(numbers.symbol(number));
  return std::string(of).append(" ").append(numbers.ordinary_name(number));
}

std::string_view PlantNames::task(std::uint32_t symbol) const {
  const tables::SymbolRow& row = tables_.symbols[symbol];
  if (row.unit != tables::kNone && row.type() == tables::DataType::boolean && is_operation(symbol)) {
    const tables::UnitRow& unit = tables_.units[row.unit];
    const std::uint32_t position = row.index - unit.operation_bit;
    const auto targets = tables_.types[unit.type].operation_targets;
    if (position < targets.size() && targets[position] != tables::kNoState) return state(row.unit, targets[position]);
  }
  const std::string_view name = this->symbol(symbol);
  const std::size_t end = name.find_last_of("_.-: ");
  return end == name.npos || end + 1 == name.size() ? name : name.substr(end + 1);
}

std::string_view PlantNames::list(std::uint32_t symbol) const {
  return lists_.empty() ? std::string_view() : lists_[tables::list_of(tables_, symbol)];
}

std::string PlantNames::cite(std::uint32_t symbol) const {
  return std::string(list(symbol)) + ":" + std::to_string(tables_.symbols[symbol].row);
}

std::span<const std::uint32_t> PlantNames::symbols_of(std::uint32_t unit) const {
  std::call_once(grouped_, [this] { group(); });
  return std::span(by_unit_).subspan(first_of_[unit], first_of_[unit + 1] - first_of_[unit]);
}

}  // namespace symplant::trace
