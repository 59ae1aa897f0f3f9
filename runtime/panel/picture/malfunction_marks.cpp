// The devices and symbols on which malfunctions act.
#include "symplant/panel/picture/malfunction_marks.hpp"

#include <algorithm>

#include "symplant/tables/malfunction_numbers.hpp"

namespace symplant::panel {

void MalfunctionMarks::change(std::uint32_t malfunction, bool active) {
  const ActsOn on = acts_on(tables_, malfunction);
  const auto count = [active](std::uint32_t& actives) { active ? ++actives : --actives; };
  for (const std::uint32_t unit : on.units) count(units_[unit]);
  for (const std::uint32_t symbol : on.symbols) count(symbols_[symbol]);
}

void MalfunctionMarks::clear() {
  std::fill(units_.begin(), units_.end(), 0);
  std::fill(symbols_.begin(), symbols_.end(), 0);
}

ActsOn acts_on(const tables::PlantTables& tables, std::uint32_t malfunction) {
  const tables::MalfunctionNumbers numbers(tables);
  if (!numbers.is_written(malfunction)) {
    if (numbers.is_of_unit(malfunction)) return {{numbers.unit(malfunction)}, {}};
    return {{}, {numbers.symbol(malfunction)}};
  }
  ActsOn on;
  const tables::MalfunctionRow& row = tables.malfunctions.rows[malfunction];
  for (const tables::MalfunctionUnit& unit : numbers.units_of(malfunction)) on.units.push_back(unit.unit);
  if (row.kind == tables::MalfunctionKind::flicker) on.symbols.push_back(row.subject);
  if (row.kind == tables::MalfunctionKind::force) {
    for (const tables::MalfunctionForce& force : tables.malfunctions.forces.subspan(row.of.first, row.of.count)) {
      on.symbols.push_back(force.symbol);
    }
  }
  return on;
}

}  // namespace symplant::panel
