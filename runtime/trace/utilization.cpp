// How the devices of a plant were used.
#include "symplant/trace/utilization.hpp"

#include <algorithm>

namespace symplant::trace {

Utilization::Utilization(const PlantNames& names, const History& history)
    : names_(names),
      history_(history),
      units_(names.tables().units.size()),
      malfunctions_(names.tables()),
      parts_(names.tables().material, history) {
  first_state_.reserve(units_.size() + 1);
  std::uint32_t states = 0;
  for (const tables::UnitRow& unit : names.tables().units) {
    first_state_.push_back(states);
    states += names.tables().types[unit.type].states;
  }
  first_state_.push_back(states);
  states_.resize(states);
  begin(0);
}

void Utilization::begin(tables::Time time) {
  from_ = time;
  std::fill(states_.begin(), states_.end(), State{});
  malfunctions_.clear();
  for (const History::Malfunction& one : history_.malfunctions()) malfunctions_.change(one.number, true);
  for (std::uint32_t u = 0; u < units_.size(); ++u) {
    const plant::UnitView view = history_.unit(u);
    Unit& unit = units_[u];
    unit = Unit();
    unit.at = time;
    unit.activity = activity_of(names_, history_, u);
    unit.state = view.state;
    unit.target = view.target;
    unit.moving = view.moving;
    unit.due = tables::kNever;
    if (view.moving) unit.move = move_of(unit, view.state, view.target);
  }
  parts_.begin(time);
}

/// The time of a unit until now is of what it did until now.
void Utilization::count(std::uint32_t u, tables::Time time) {
  Unit& unit = units_[u];
  const tables::Time passed = time - unit.at;
  if (passed <= 0) return;
  unit.at = time;
  unit.times[static_cast<std::size_t>(unit.activity)] += passed;
  if (malfunctions_.unit(u)) unit.malfunction += passed;
  (unit.moving ? unit.moves[unit.move].time : states_[first_state_[u] + unit.state].time) += passed;
}

std::uint32_t Utilization::move_of(Unit& unit, std::uint8_t from, std::uint8_t to) {
  const auto found = std::find_if(unit.moves.begin(), unit.moves.end(),
                                  [&](const MoveUse& move) { return move.from == from && move.to == to; });
  if (found == unit.moves.end()) {
    unit.moves.push_back({from, to, 0, {}});
    return static_cast<std::uint32_t>(unit.moves.size() - 1);
  }
  return static_cast<std::uint32_t>(found - unit.moves.begin());
}

void Utilization::enter(std::uint32_t unit, std::uint8_t state, tables::Time time) {
  states_[first_state_[unit] + state].entries.add(time);
}

/// A unit that was moving does something else: it arrived, turned round, or was put into a state by hand.
void Utilization::leave_move(std::uint32_t u, const plant::UnitView& view, tables::Time time) {
  Unit& unit = units_[u];
  const bool went_on = view.moving && view.target != unit.state;
  const bool arrived = view.state == unit.target && (time >= unit.due || went_on);
  if (arrived) {
    if (unit.started >= 0) unit.moves[unit.move].whole.add(time - unit.started);
    enter(u, unit.target, time);
  } else if (!view.moving) {
    enter(u, view.state, time);
  }
  unit.started = arrived ? time : -1;
}

/// A unit is in another state, or its move begins, changes or ends.
void Utilization::follow(std::uint32_t u, const Record& record) {
  Unit& unit = units_[u];
  const plant::UnitView view = unpack_unit(record.value);
  const bool goes_on = unit.moving && view.moving && view.state == unit.state && view.target == unit.target;
  if (unit.moving && !goes_on) {
    leave_move(u, view, record.time);
  } else if (!unit.moving) {
    unit.started = record.time;
    if (view.state != unit.state) {
      unit.moves[move_of(unit, unit.state, view.state)].whole.add(0);
      enter(u, view.state, record.time);
    }
  }
  unit.due = runs(view) ? record.time + remaining_of(record.value) : tables::kNever;
  unit.state = view.state;
  unit.target = view.target;
  unit.moving = view.moving;
  if (view.moving) unit.move = move_of(unit, view.state, view.target);
}

void Utilization::malfunction(const Record& record) {
  for (const std::uint32_t unit : acts_on(names_.tables(), record.of).units) count(unit, record.time);
  malfunctions_.change(record.of, record.more);
}

void Utilization::apply(const Record& record) {
  std::uint32_t unit = tables::kNone;
  if (record.kind == Record::Kind::unit) {
    unit = record.of;
    count(unit, record.time);
    follow(unit, record);
  } else if (record.kind == Record::Kind::change) {
    unit = names_.is_operation(record.of) ? names_.tables().symbols[record.of].unit : tables::kNone;
    if (unit != tables::kNone) count(unit, record.time);
  } else if (record.kind == Record::Kind::malfunction) {
    malfunction(record);
  } else {
    parts_.apply(record);
  }
  if (unit != tables::kNone) units_[unit].activity = activity_of(names_, history_, unit);
}

std::optional<CycleUse> Utilization::cycle(std::uint32_t unit) const {
  const auto entries = [&](std::uint32_t state) -> const Intervals& { return states_[state].entries; };
  std::uint32_t best = first_state_[unit] + names_.tables().units[unit].initial;
  if (entries(best).events < 2) {
    for (std::uint32_t s = first_state_[unit]; s < first_state_[unit + 1]; ++s) {
      if (entries(s).events > entries(best).events) best = s;
    }
  }
  if (entries(best).events < 2) return std::nullopt;
  return CycleUse{static_cast<std::uint8_t>(best - first_state_[unit]), entries(best).between};
}

DeviceUse Utilization::device(std::uint32_t u, tables::Time now) const {
  const Unit& unit = units_[u];
  DeviceUse use{
      .times = unit.times, .malfunction = unit.malfunction, .states = {}, .moves = unit.moves, .cycle = cycle(u)};
  for (std::uint32_t s = first_state_[u]; s < first_state_[u + 1]; ++s) use.states.push_back(states_[s].time);
  const tables::Time passed = std::max<tables::Time>(now - unit.at, 0);
  use.times[static_cast<std::size_t>(unit.activity)] += passed;
  if (malfunctions_.unit(u)) use.malfunction += passed;
  (unit.moving ? use.moves[unit.move].time : use.states[unit.state]) += passed;
  return use;
}

}  // namespace symplant::trace
