// Device types.
#include "lower/type_table.hpp"

#include <algorithm>

namespace symplant::lower {
namespace {

using model::kNone;

std::uint64_t bit(std::uint32_t place) { return std::uint64_t{1} << place; }

/// The events that stand on the address of `event`, among the unit's own: they come on and go off together. None where
/// they follow another unit's event: that one alone says what is there.
std::uint64_t events_with(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t event) {
  const auto leader_of = [&](std::uint32_t place) {
    const std::uint32_t symbol = unit.events[place];
    const std::uint32_t leader = plant.symbols[symbol].leader;
    return leader == kNone ? symbol : leader;
  };
  const std::uint32_t leader = leader_of(event);
  if (std::find(unit.events.begin(), unit.events.end(), leader) == unit.events.end()) return 0;
  std::uint64_t events = 0;
  for (std::uint32_t other = 0; other < unit.events.size(); ++other) {
    if (leader_of(other) == leader) events |= bit(other);
  }
  return events;
}

Type make_type(const model::PlantModel& plant, std::uint32_t index) {
  const model::Unit& unit = plant.units[index];
  Type type{};
  type.example = index;
  type.operations = static_cast<std::uint8_t>(unit.operations.size());
  type.events = static_cast<std::uint8_t>(unit.events.size());
  type.states = static_cast<std::uint8_t>(unit.states.size());
  type.actuation = unit.actuation;
  const bool springs = unit.actuation == core::Actuation::spring;
  type.rest = springs ? static_cast<std::uint8_t>(unit.rest) : core::kNoState;
  for (const model::Transition& t : unit.transitions) {
    type.transitions.push_back({static_cast<std::uint8_t>(t.from), static_cast<std::uint8_t>(t.to),
                                t.on == kNone ? core::kNoOperation : static_cast<std::uint8_t>(t.on)});
  }
  type.operation_targets.assign(unit.operations.size(), core::kNoState);
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    const model::State& state = unit.states[s];
    const std::uint64_t events = state.event == kNone ? 0 : events_with(plant, unit, state.event);
    type.enter.push_back(events);
    type.leave.push_back(events);
    if (state.operation != kNone) type.operation_targets[state.operation] = static_cast<std::uint8_t>(s);
  }
  return type;
}

/// Everything that two units of one type have in common, as one text.
std::string structure_of(const Type& type, const model::PlantModel& plant) {
  const model::Unit& unit = plant.units[type.example];
  std::string text;
  const auto number = [&](std::uint64_t value) {
    for (int i = 0; i < 8; ++i) text.push_back(static_cast<char>(value >> (8 * i)));
  };
  const auto byte = [&](std::uint8_t value) { text.push_back(static_cast<char>(value)); };
  byte(type.operations);
  byte(type.events);
  byte(type.states);
  byte(type.rest);
  byte(static_cast<std::uint8_t>(type.actuation));
  for (const core::Transition& t : type.transitions) {
    byte(t.from);
    byte(t.to);
    byte(t.on);
  }
  for (const std::uint64_t events : type.enter) number(events);
  for (const std::uint8_t state : type.operation_targets) byte(state);
  for (const model::State& state : unit.states) text.append(state.name).push_back('\0');
  for (const auto* side : {&unit.operations, &unit.events}) {
    for (const std::uint32_t symbol : *side) text.append(plant.symbols[symbol].reading.task).push_back('\0');
  }
  return text;
}

}  // namespace

std::uint32_t TypeTable::type_of(const model::PlantModel& plant, std::uint32_t unit, std::vector<Type>& types) {
  Type type = make_type(plant, unit);
  const auto [found, added] =
      by_structure_.try_emplace(structure_of(type, plant), static_cast<std::uint32_t>(types.size()));
  if (added) types.push_back(std::move(type));
  return found->second;
}

}  // namespace symplant::lower
