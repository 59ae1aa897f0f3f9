// The current values of symbols and states of units, and their latest changes.
#include "symplant/trace/history.hpp"

#include <algorithm>

namespace symplant::trace {

History::History(const PlantNames& names)
    : names_(names),
      values_(names.tables().symbols.size()),
      changed_(values_.size()),
      rose_(values_.size(), -1),
      unit_changed_(names.tables().units.size()) {
  const tables::PlantTables& tables = names.tables();
  for (const tables::InitialValue& initial : tables.initial_values) {
    if (tables.symbols[initial.symbol].type() != tables::DataType::boolean) values_[initial.symbol] = initial.value;
  }
  for (const tables::SharedAddress& shared :
       tables.shared_addresses) {  // numbers of one address share one initial value
    if (tables.symbols[shared.symbol].type() == tables::DataType::boolean) continue;
    if (values_[shared.symbol] == 0) values_[shared.symbol] = values_[shared.leader];
  }
  units_.reserve(tables.units.size());
  for (const tables::UnitRow& unit : tables.units) {
    units_.push_back(static_cast<std::uint32_t>(unit.initial | unit.initial << 8));
  }
}

void History::apply(const Record& record) {
  if (record.kind == Record::Kind::change) {
    if (record.value != 0 && values_[record.of] == 0) rose_[record.of] = record.time;
    values_[record.of] = record.value;
    changed_[record.of] = record.time;
  } else if (record.kind == Record::Kind::unit) {
    units_[record.of] = static_cast<std::uint32_t>(record.value);
    unit_changed_[record.of] = record.time;
  }
}

std::vector<std::uint32_t> History::last_operations(std::uint32_t unit, std::size_t most) const {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t symbol : names_.symbols_of(unit)) {
    if (names_.is_operation(symbol) && rose_[symbol] >= 0) found.push_back(symbol);
  }
  std::stable_sort(found.begin(), found.end(),
                   [this](std::uint32_t a, std::uint32_t b) { return rose_[a] > rose_[b]; });
  if (found.size() > most) found.resize(most);
  return found;
}

}  // namespace symplant::trace
