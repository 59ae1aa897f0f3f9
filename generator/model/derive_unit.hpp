// One unit's I/O model from the tasks of its symbols and what the description says of its device.
#pragma once

#include <vector>

#include "description/faults.hpp"
#include "model/evidence.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Derives S, rest, initial state and actuation of a unit whose symbols and description are known (docs/model.md).
/// `symbols` are the plant's. O(symbols of the unit).
UnitEvidence derive_states(Unit& unit, const std::vector<Symbol>& symbols, const description::Defaults& defaults,
                           description::Faults& faults);

/// Derives the transitions and outputs of a unit after derive_states(), except those in Unit::left_out. Relations to
/// other units (conditions and disables) are not resolved. O(states squared): every state can be left by every
/// operation.
void derive_transitions(Unit& unit, const std::vector<Symbol>& symbols, const description::Defaults& defaults,
                        UnitEvidence& evidence, description::Faults& faults);

}  // namespace symplant::model
