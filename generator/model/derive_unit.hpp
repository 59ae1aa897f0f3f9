// One unit's I/O model from the tasks of its symbols and what the description says of its device.
#pragma once

#include <vector>

#include "description/faults.hpp"
#include "model/evidence.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Derives S, transitions, rest, initial state, actuation and outputs of a unit whose symbols and description are known
/// (docs/model.md). Relations to other units, conditions and disables, are left open. `symbols` are the plant's.
/// O(states squared): every state can be left by every operation.
UnitEvidence derive_unit(Unit& unit, const std::vector<Symbol>& symbols, const description::Defaults& defaults,
                         description::Faults& faults);

}  // namespace symplant::model
