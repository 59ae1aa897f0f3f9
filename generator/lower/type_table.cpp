// Device types, shared by units of equal structure.
#include "lower/type_table.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "symplant/tables/fields.hpp"

namespace symplant::lower {
namespace {

using model::kNone;

std::uint64_t bit(std::uint32_t position) { return std::uint64_t{1} << position; }

bool is_driven(const model::PlantModel& plant, std::uint32_t event) {
  const std::uint32_t unit = plant.symbols[event].unit;
  if (unit == kNone) return plant.symbols[event].driven_without_unit();
  const auto& events = plant.units[unit].events;
  const auto position = std::find(events.begin(), events.end(), event) - events.begin();
  return plant.units[unit].moves_event(static_cast<std::uint32_t>(position));
}

/// Events on one address. Their bits are equal: those that are inverted as the first one is are on with it, the others
/// are off then.
struct Together {
  std::uint64_t same = 0;
  std::uint64_t opposite = 0;
};

/// The unit's events on the address of `event`. Empty if they follow an event of another unit or one that follows a
/// condition, which alone decides their value.
Together events_with(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t event) {
  const auto leader_of = [&](std::uint32_t position) {
    const std::uint32_t symbol = unit.events[position];
    const std::uint32_t leader = plant.symbols[symbol].leader;
    return leader == kNone ? symbol : leader;
  };
  const std::uint32_t leader = leader_of(event);
  const bool own = std::find(unit.events.begin(), unit.events.end(), leader) != unit.events.end();
  if (!own && is_driven(plant, leader)) return {};
  Together events;
  const bool inverted = plant.symbols[unit.events[event]].inverted;
  for (std::uint32_t other = 0; other < unit.events.size(); ++other) {
    if (leader_of(other) != leader) continue;
    (plant.symbols[unit.events[other]].inverted == inverted ? events.same : events.opposite) |= bit(other);
  }
  return events;
}

/// Sets or clears events; of several assignments to one event the last counts.
void assign(tables::EventMasks& masks, const Together& events, bool on) {
  const std::uint64_t rising = on ? events.same : events.opposite;
  const std::uint64_t falling = on ? events.opposite : events.same;
  masks.on = (masks.on | rising) & ~falling;
  masks.off = (masks.off | falling) & ~rising;
}

/// The events that entering (`on`) or leaving a state switches: its event, then the outputs.
tables::EventMasks masks_of(const model::PlantModel& plant, const model::Unit& unit, const model::State& state, bool on,
                            const std::vector<std::pair<std::uint32_t, bool>>& outputs) {
  tables::EventMasks masks{};
  if (state.event != kNone) assign(masks, events_with(plant, unit, state.event), on);
  for (const auto& [event, value] : outputs) assign(masks, events_with(plant, unit, event), value);
  return masks;
}

tables::Transition lowered(const model::Transition& t) {
  tables::Transition row{};
  row.from = static_cast<std::uint8_t>(t.from);
  row.to = static_cast<std::uint8_t>(t.to);
  row.on = t.on == kNone ? tables::kNoOperation : static_cast<std::uint8_t>(t.on);
  if (t.spring_return) row.on = tables::kSpringReturn;
  row.once = t.once;
  row.when = t.when == kNone ? tables::kNoCondition : static_cast<std::uint16_t>(t.when);
  row.during = t.during == kNone ? tables::kNoCondition : static_cast<std::uint16_t>(t.during);
  row.numbers = t.numbers;
  return row;
}

void make_type(const model::PlantModel& plant, std::uint32_t index, Type& type) {
  const model::Unit& unit = plant.units[index];
  type.example = index;
  type.operations = static_cast<std::uint8_t>(unit.operations.size());
  type.events = static_cast<std::uint8_t>(unit.events.size());
  type.states = static_cast<std::uint8_t>(unit.states.size());
  type.actuation = unit.actuation;
  const bool springs = unit.actuation == tables::Actuation::spring;
  type.rest = springs ? static_cast<std::uint8_t>(unit.rest) : tables::kNoState;
  type.transitions.clear();
  type.transitions.reserve(unit.transitions.size());
  for (const model::Transition& t : unit.transitions) type.transitions.push_back(lowered(t));
  type.operation_targets.assign(unit.operations.size(), tables::kNoState);
  type.enter.clear();
  type.leave.clear();
  const model::Outputs none;
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    const model::State& state = unit.states[s];
    const model::Outputs& outputs = unit.outputs.empty() ? none : unit.outputs[s];
    type.enter.push_back(masks_of(plant, unit, state, true, outputs.enter));
    type.leave.push_back(masks_of(plant, unit, state, false, outputs.leave));
    if (state.operation != kNone) type.operation_targets[state.operation] = static_cast<std::uint8_t>(s);
  }
}

/// Appends everything that units of one type have in common, as a text.
void put_structure(const Type& type, const model::PlantModel& plant, std::string& text) {
  const model::Unit& unit = plant.units[type.example];
  text.clear();
  const auto number = [&](std::uint64_t value) {
    std::array<char, sizeof value> bytes{};
    std::memcpy(bytes.data(), &value, sizeof value);
    text.append(bytes.data(), bytes.size());
  };
  const auto byte = [&](std::uint8_t value) { text.push_back(static_cast<char>(value)); };
  byte(type.operations);
  byte(type.events);
  byte(type.states);
  byte(type.rest);
  byte(static_cast<std::uint8_t>(type.actuation));
  number(type.transitions.size());
  for (const tables::Transition& t : type.transitions) {
    byte(t.from);
    byte(t.to);
    byte(t.on);
    byte(t.once ? 1 : 0);
    number(std::uint64_t{t.when} << 16 | t.during);
    tables::fields(t.numbers, number);
  }
  for (const auto* side : {&type.enter, &type.leave}) {
    for (const tables::EventMasks& masks : *side) {
      number(masks.on);
      number(masks.off);
    }
  }
  for (const std::uint8_t state : type.operation_targets) byte(state);
  for (const model::State& state : unit.states) text.append(state.name).push_back('\0');
  for (const auto* side : {&unit.operations, &unit.events}) {
    for (const std::uint32_t symbol : *side) text.append(plant.symbols[symbol].reading.task()).push_back('\0');
  }
  if (unit.described != nullptr) text.append(unit.described->type);
  text.push_back('\0');
  if (unit.has_behaviour()) text.append(unit.described->behaviour);  // the custom class derives from the type
}

}  // namespace

std::uint32_t TypeTable::type_of(const model::PlantModel& plant, std::uint32_t unit, std::vector<Type>& types) {
  make_type(plant, unit, type_);
  put_structure(type_, plant, structure_);
  const auto next = static_cast<std::uint32_t>(types.size());
  const auto [found, added] = by_structure_.try_emplace(structure_, next);
  if (added) types.push_back(type_);
  return found->second;
}

}  // namespace symplant::lower
