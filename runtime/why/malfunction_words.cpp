// What active malfunctions add to explanations.
#include "symplant/why/malfunction_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::why {
namespace {

using tables::MalfunctionKind;
using tables::MalfunctionNumbers;

std::string named(std::uint32_t malfunction, const trace::PlantNames& names) {
  return fmt::format("malfunction `{}`", names.malfunction(malfunction));
}

/// Those of a kind that name a unit.
std::string of_unit(std::uint32_t unit, MalfunctionKind kind, const trace::PlantNames& names,
                    ActiveMalfunctions active) {
  const MalfunctionNumbers numbers(names.tables());
  std::string text;
  for (const trace::History::Malfunction& one : active) {
    if (numbers.kind(one.number) != kind || !numbers.names_unit(one.number, unit)) continue;
    text += (text.empty() ? "" : ", ") + named(one.number, names);
  }
  return text;
}

bool overrides(std::uint32_t malfunction, std::uint32_t symbol, const tables::PlantTables& tables) {
  const MalfunctionNumbers numbers(tables);
  if (!numbers.is_written(malfunction)) {
    return !numbers.is_of_unit(malfunction) && numbers.symbol(malfunction) == symbol;
  }
  const tables::MalfunctionRow& row = tables.malfunctions.rows[malfunction];
  if (row.kind == MalfunctionKind::flicker) return row.subject == symbol;
  if (row.kind != MalfunctionKind::force) return false;
  return std::ranges::any_of(tables.malfunctions.forces.subspan(row.of.first, row.of.count),
                             [symbol](const tables::MalfunctionForce& force) { return force.symbol == symbol; });
}

}  // namespace

std::string disabling_malfunctions(std::uint32_t unit, const trace::PlantNames& names, ActiveMalfunctions active) {
  return of_unit(unit, MalfunctionKind::stuck, names, active);
}

std::string slowing_malfunctions(std::uint32_t unit, const trace::PlantNames& names, ActiveMalfunctions active) {
  const std::string slow = of_unit(unit, MalfunctionKind::slower, names, active);
  return slow.empty() ? "" : ", slowed by " + slow;
}

std::string overriding_malfunction(std::uint32_t symbol, const trace::PlantNames& names, ActiveMalfunctions active) {
  const auto last = std::find_if(active.rbegin(), active.rend(), [&](const trace::History::Malfunction& one) {
    return overrides(one.number, symbol, names.tables());
  });
  return last == active.rend() ? "" : ", forced by " + named(last->number, names);
}

void add_malfunctions(Explanation& explanation, const trace::PlantNames& names, ActiveMalfunctions active) {
  const std::string said = in_one_line(explanation);
  for (const trace::History::Malfunction& one : active) {
    if (said.find(named(one.number, names)) != std::string::npos) continue;
    explanation.because.push_back(
        {fmt::format("{} is active {}", named(one.number, names), trace::since_words(one.since))});
  }
}

}  // namespace symplant::why
