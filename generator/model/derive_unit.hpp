// One unit's I/O model from the tasks of its symbols.
#pragma once

#include <vector>

#include "model/plant_model.hpp"

namespace symplant::model {

/// Derives S, transitions, rest, initial state and actuation of a unit whose symbols are known (docs/model.md).
/// `symbols` are the plant's. O(states squared): every state can be left by every operation.
void derive_unit(Unit& unit, const std::vector<Symbol>& symbols);

/// S alone, in its order: every task that an operation or an event names.
std::vector<State> states_of(const Unit& unit, const std::vector<Symbol>& symbols);

}  // namespace symplant::model
