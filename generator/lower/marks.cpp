// Marks the transitions and units that need a record in the engine.
#include "lower/marks.hpp"

#include <algorithm>
#include <vector>

namespace symplant::lower {
namespace {

/// Whether times have a delay or a random travel time; a fixed time of 0 is neither.
bool timed(const tables::TransitionTimes& times) { return times.after != 0 || times.takes < 0; }

void mark_transitions(EngineTables& tables) {
  for (Type& type : tables.types) {
    for (tables::Transition& t : type.transitions) {
      t.timed =
          t.numbers != tables::TransitionNumbers{} || ((t.dt & tables::kOfDevice) == 0 && timed(type.times[t.dt]));
    }
  }
  for (const tables::UnitRow& unit : tables.units) {
    for (tables::Transition& t : tables.types[unit.type].transitions) {
      if ((t.dt & tables::kOfDevice) == 0) continue;
      if (timed(tables.times[unit.times + (t.dt ^ tables::kOfDevice)])) t.timed = true;
    }
  }
  for (const tables::BehaviourUnit& row : tables.behaviour_units) {
    for (tables::Transition& t : tables.types[tables.units[row.unit].type].transitions) t.timed = true;
  }
}

}  // namespace

void mark_what_costs_more(EngineTables& tables) {
  mark_transitions(tables);
  std::vector<bool> general_types;
  general_types.reserve(tables.types.size());
  for (const Type& type : tables.types) {
    general_types.push_back(std::any_of(type.transitions.begin(), type.transitions.end(),
                                        [](const tables::Transition& t) { return t.timed; }));
  }
  for (tables::UnitRow& unit : tables.units) unit.general = general_types[unit.type] ? 1 : 0;
  for (const tables::ConditionedUnit& row : tables.conditioned_units) tables.units[row.unit].general = 1;
  for (const tables::BehaviourUnit& row : tables.behaviour_units) tables.units[row.unit].general = 1;
  for (const tables::UnitWatch& row : tables.unit_watches) tables.units[row.unit].general = 1;
  for (const tables::DisableRow& row : tables.disables) {
    tables.units[row.by].general = 1;
    tables.units[row.unit].general = 1;
  }
}

}  // namespace symplant::lower
