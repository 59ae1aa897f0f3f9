// The current values of symbols and states of units, and their latest changes.
#include "symplant/trace/history.hpp"

#include <algorithm>
#include <bit>

#include "symplant/trace/value_traces.hpp"

namespace symplant::trace {

History::History(const PlantNames& names)
    : names_(names),
      bits_(names.tables().symbols.size()),
      numbers_(names.tables().operation_slots + names.tables().event_slots),
      changed_(bits_.size()),
      rose_(std::size_t{names.tables().operation_bits} + names.tables().operation_slots),
      unit_changed_(names.tables().units.size()),
      parts_(names.tables().material.locations()) {
  const tables::PlantTables& tables = names.tables();
  for (const tables::InitialValue& initial : tables.initial_values) {
    const tables::SymbolRow& symbol = tables.symbols[initial.symbol];
    if (symbol.type() != tables::DataType::boolean) numbers_[slot(symbol)] = initial.value;
  }
  for (const tables::SharedAddress& shared :
       tables.shared_addresses) {  // numbers of one address share one initial value
    const tables::SymbolRow& symbol = tables.symbols[shared.symbol];
    if (symbol.type() == tables::DataType::boolean) continue;
    std::uint64_t& number = numbers_[slot(symbol)];
    if (number == 0) number = value(shared.leader);
  }
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {  // as if commanding, until the first instant reports them
    const tables::SymbolRow& symbol = tables.symbols[i];
    if (symbol.inverted() && symbol.direction() == tables::Direction::operation) rose_[risen(i)] = 1;
  }
  for (const tables::ValueRow& row : tables.values.rows) {
    outputs_.insert(outputs_.end(), row.outputs, row.start_output());
  }
  traces_ = traces_of(tables.values);
  units_.reserve(tables.units.size());
  for (const tables::UnitRow& unit : tables.units) {
    units_.push_back(static_cast<std::uint32_t>(unit.initial | unit.initial << 8));
  }
}

std::size_t History::slot(const tables::SymbolRow& symbol) const {
  return symbol.index + (symbol.direction() == tables::Direction::event ? names_.tables().operation_slots : 0);
}

std::size_t History::risen(std::uint32_t operation) const {
  const tables::SymbolRow& row = names_.tables().symbols[operation];
  return row.index + (row.type() == tables::DataType::boolean ? 0 : names_.tables().operation_bits);
}

std::uint64_t History::value(std::uint32_t symbol) const {
  const tables::SymbolRow& row = names_.tables().symbols[symbol];
  return row.type() == tables::DataType::boolean ? bits_[symbol] : numbers_[slot(row)];
}

bool History::commands(std::uint32_t operation) const {
  return (value(operation) != 0) != names_.tables().symbols[operation].inverted();
}

void History::apply(const Record& record) {
  if (record.kind == Record::Kind::change) {
    const tables::SymbolRow& symbol = names_.tables().symbols[record.of];
    if (symbol.direction() == tables::Direction::operation) {
      const bool on = (record.value != 0) != symbol.inverted();
      if (on && !commands(record.of)) rose_[risen(record.of)] = record.time + 1;
      if (!on && symbol.inverted() && record.time == 0) rose_[risen(record.of)] = 0;  // it starts without a command
    }
    if (symbol.type() == tables::DataType::boolean) {
      bits_[record.of] = record.value != 0;
    } else {
      numbers_[slot(symbol)] = record.value;
    }
    if (changed_[record.of] != record.time) changed_[record.of] = record.time;
  } else if (record.kind == Record::Kind::unit) {
    units_[record.of] = static_cast<std::uint32_t>(record.value & ((1U << kUnitBits) - 1));
    unit_changed_[record.of] = record.time;
  } else if (record.kind == Record::Kind::part) {
    part_ = record;
  } else if (record.kind == Record::Kind::part_move) {
    move_part(part_record(part_, record));
  } else if (record.kind == Record::Kind::value) {
    outputs_[record.of] = std::bit_cast<double>(record.value);
  } else if (record.kind == Record::Kind::malfunction) {
    std::erase_if(malfunctions_, [&](const Malfunction& one) { return one.number == record.of; });
    if (record.more) {
      malfunctions_.push_back({record.of, record.time, static_cast<engine::MalfunctionChange::By>(record.value)});
    }
  }
}

void History::load_symbol(std::uint32_t symbol, const plant::Plant& plant) {
  const tables::SymbolRow& row = names_.tables().symbols[symbol];
  const bool operation = row.direction() == tables::Direction::operation;
  std::uint64_t value = 0;
  if (row.type() == tables::DataType::boolean) {
    value = (operation ? plant.operation(row.index) : plant.event(row.index)) ? 1 : 0;
  } else {
    value = operation ? plant.operation_value(row.index) : plant.event_value(row.index);
  }
  if (value != this->value(symbol)) apply({plant.now(), value, symbol});
  if (plant.is_forced(symbol)) forced_[symbol] = plant.now();
}

void History::forget_after(tables::Time now) {
  for (std::uint32_t s = 0; s < bits_.size(); ++s) {
    if (changed_[s] > now) changed_[s] = now;
    if (names_.tables().symbols[s].direction() == tables::Direction::event || rose(s) <= now) continue;
    rose_[risen(s)] = commands(s) ? now + 1 : 0;
  }
  for (std::uint32_t u = 0; u < units_.size(); ++u) {
    if (unit_changed_[u] > now) unit_changed_[u] = now;
  }
}

void History::load(const plant::Plant& plant) {
  forced_.clear();
  for (std::uint32_t s = 0; s < bits_.size(); ++s) load_symbol(s, plant);
  for (std::uint32_t u = 0; u < units_.size(); ++u) {
    const auto word = static_cast<std::uint32_t>(pack_unit(plant.unit(u)));
    if (word != units_[u]) apply({plant.now(), word, u, Record::Kind::unit});
  }
  for (std::uint32_t o = 0; o < outputs_.size(); ++o) outputs_[o] = plant.output(o);
  forget_after(plant.now());
  malfunctions_.clear();
  for (const engine::ActiveMalfunction& one : plant.active_malfunctions()) {
    malfunctions_.push_back({one.number, one.since, one.by});
  }
  for (std::uint32_t location = 0; location < parts_.size(); ++location) {
    parts_[location].clear();
    for (std::uint32_t i = 0; i < plant.parts(location); ++i) {
      const plant::PartView part = plant.part(location, i);
      parts_[location].push_back({part.number, part.kind, part.since});
    }
    std::stable_sort(parts_[location].begin(), parts_[location].end(),
                     [](const Part& a, const Part& b) { return a.since < b.since; });
  }
}

void History::move_part(const PartRecord& part) {
  const auto has_number = [&](const Part& other) { return other.number == part.number; };
  if (part.changed()) {
    for (std::vector<Part>& parts : parts_) {
      const auto found = std::find_if(parts.begin(), parts.end(), has_number);
      if (found != parts.end()) found->kind = part.kind;
    }
    return;
  }
  if (!part.made()) std::erase_if(parts_[part.from], has_number);
  if (part.to != tables::kOut) parts_[part.to].push_back({part.number, part.kind, part.time});
}

const History::Part* History::part(std::uint64_t number) const {
  for (const std::vector<Part>& parts : parts_) {
    for (const Part& part : parts) {
      if (part.number == number) return &part;
    }
  }
  return nullptr;
}

void History::force(std::uint32_t symbol, bool forced, tables::Time time) {
  if (forced) {
    forced_[symbol] = time;
  } else {
    forced_.erase(symbol);
  }
}

tables::Time History::forced_since(std::uint32_t symbol) const {
  const auto found = forced_.find(symbol);
  return found == forced_.end() ? -1 : found->second;
}

std::vector<std::uint32_t> History::last_operations(std::uint32_t unit, std::size_t most) const {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t symbol : names_.symbols_of(unit)) {
    if (names_.is_operation(symbol) && rose(symbol) >= 0) found.push_back(symbol);
  }
  std::stable_sort(found.begin(), found.end(), [this](std::uint32_t a, std::uint32_t b) { return rose(a) > rose(b); });
  if (found.size() > most) found.resize(most);
  return found;
}

}  // namespace symplant::trace
