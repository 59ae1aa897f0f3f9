// Makes S, the states of a unit.
#pragma once

#include <vector>

#include "description/faults.hpp"
#include "model/plant_model.hpp"
#include "model/task_roles.hpp"

namespace symplant::model {

/// The states that symbols name, in the order of S: every task that is a state. `symbols` are the plant's.
/// O(tasks log tasks).
std::vector<State> states_of(const Unit& unit, const std::vector<Symbol>& symbols, const TaskRoles& roles);

/// Puts the states that the facet names first, in its order.
void sort_by_facet(Unit& unit);

/// Appends the states that the description adds, in its order.
void add_given_states(Unit& unit, description::Faults& faults);

}  // namespace symplant::model
