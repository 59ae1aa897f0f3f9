// The devices and symbols on which malfunctions act.
#include "symplant/trace/malfunction_marks.hpp"

#include <algorithm>

#include "symplant/tables/malfunction_numbers.hpp"

namespace symplant::trace {

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
  ActsOn on;
  numbers.for_symbols(malfunction, [&](std::uint32_t symbol) { on.symbols.push_back(symbol); });
  if (!numbers.is_written(malfunction)) {
    if (numbers.is_of_unit(malfunction)) on.units.push_back(numbers.unit(malfunction));
    return on;
  }
  for (const tables::EffectRow& effect : tables.malfunctions.effects_of(malfunction)) {
    for (const tables::MalfunctionUnit& unit : tables.malfunctions.units_of(effect)) on.units.push_back(unit.unit);
    if (effect.kind == tables::MalfunctionKind::distort) {
      on.symbols.push_back(tables.values.signals[effect.subject].symbol);
    }
  }
  return on;
}

}  // namespace symplant::trace
