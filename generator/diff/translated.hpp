// The old model in the names of the new one, so that a renamed symbol does not show as a change of every condition.
#pragma once

#include <cstdint>
#include <vector>

#include "diff/symbols.hpp"

namespace symplant::diff {

/// By old symbol: the new one; kNone if it was removed or is no I/O symbol any more.
std::vector<std::uint32_t> symbols_after(const model::PlantModel& before, const model::PlantModel& after,
                                         const SymbolPairs& pairs);

/// By old device: the new one; kNone if it was removed. Devices of one name are a pair. Of the others, those of which
/// more than half of the symbols are pairs: a renamed device. O(devices + symbols).
std::vector<std::uint32_t> units_after(const model::PlantModel& before, const model::PlantModel& after,
                                       const std::vector<std::uint32_t>& symbols);

/// The old state of a device that has, under another name, the operation or the event of a new one; by new state,
/// kNone without one. A name that both devices have is never another name. O(states log states).
std::vector<std::uint32_t> renamed_states(const model::Unit& before, const model::Unit& after,
                                          const std::vector<std::uint32_t>& symbols);

/// A copy of the old model with the new names of symbols, devices and states. O(model).
model::PlantModel translated(const model::PlantModel& before, const model::PlantModel& after,
                             const std::vector<std::uint32_t>& symbols, const std::vector<std::uint32_t>& units);

}  // namespace symplant::diff
