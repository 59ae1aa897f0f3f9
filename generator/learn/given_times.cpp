// Finds the entries of `times` that are for a device.
#include "learn/given_times.hpp"

#include <string_view>

#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::learn {

GivenTimes::GivenTimes(const model::PlantModel& plant) : plant_(plant), by_unit_(plant.units.size()) {
  text::ByName<std::vector<std::uint32_t>> units;
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    const model::Unit& unit = plant.units[u];
    units[unit.path].push_back(u);
    if (unit.device_path().size() != unit.path.size()) units[unit.device_path()].push_back(u);
  }
  for (const description::GivenTimes& entry : plant.description->times) {
    if (const auto found = units.find(entry.device); found != units.end()) {
      for (const std::uint32_t unit : found->second) by_unit_[unit].push_back(&entry);
    }
    if (!text::is_pattern(entry.device)) continue;
    for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
      const model::Unit& unit = plant.units[u];
      if (text::matches_pattern(unit.path, entry.device) || text::matches_pattern(unit.device_path(), entry.device)) {
        by_unit_[u].push_back(&entry);
      }
    }
  }
}

GivenBefore GivenTimes::of(std::uint32_t u, const TransitionMoves& moves) const {
  const model::Unit& unit = plant_.units[u];
  const std::uint32_t on = moves.transition == kNone ? kNone : unit.transitions[moves.transition].on;
  const std::string_view task = on == kNone ? std::string_view() : plant_.symbols[unit.operations[on]].reading.task();
  GivenBefore given;
  for (const description::GivenTimes* entry : by_unit_[u]) {
    for (const description::GivenTime& time : entry->transitions) {
      const bool is_from = time.of.from == "*" || text::equal_ignoring_case(time.of.from, unit.states[moves.from].name);
      if (!is_from || !text::equal_ignoring_case(time.of.to, unit.states[moves.to].name)) continue;
      if (!time.of.on.empty() && !text::equal_ignoring_case(time.of.on, task)) continue;
      given.after = given.after || time.after;
      given.takes = given.takes || time.takes;
    }
  }
  return given;
}

}  // namespace symplant::learn
