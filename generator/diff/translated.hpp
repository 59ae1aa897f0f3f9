// The old model in the names of the new one, so that a renamed symbol does not show as a change of every condition.
#pragma once

#include <cstdint>
#include <vector>

#include "diff/symbols.hpp"

namespace symplant::diff {

/// By old symbol: the new one; kNone if it was removed or is no longer an I/O symbol.
std::vector<std::uint32_t> symbols_after(const model::PlantModel& before, const model::PlantModel& after,
                                         const SymbolPairs& pairs);

/// By old device: the new one; kNone if it was removed. Devices with equal names are a pair. Two other devices are a
/// pair, that is a renamed device, if more than half of their symbols are pairs. O(devices + symbols).
std::vector<std::uint32_t> units_after(const model::PlantModel& before, const model::PlantModel& after,
                                       const std::vector<std::uint32_t>& symbols);

/// By new state of a device: the old state that has its operation or event under another name; kNone without one. A
/// state whose name is in both devices is not renamed. O(states log states).
std::vector<std::uint32_t> renamed_states(const model::Unit& before, const model::Unit& after,
                                          const std::vector<std::uint32_t>& symbols);

/// A copy of the old model with the new names of symbols, devices and states. O(model).
model::PlantModel translated(const model::PlantModel& before, const model::PlantModel& after,
                             const std::vector<std::uint32_t>& symbols, const std::vector<std::uint32_t>& units);

}  // namespace symplant::diff
