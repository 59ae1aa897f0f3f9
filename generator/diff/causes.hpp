// Finds the common causes of many changes.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diff/difference.hpp"

namespace symplant::diff {

/// What was replaced in a name, in whole words: `S201` and `S301` for `L1_S201_CL1` and `L1_S301_CL1`. Words consist
/// of letters and digits. O(names).
std::pair<std::string_view, std::string_view> replaced_words(std::string_view before, std::string_view after);

/// The causes with at least kLeastMembers changes. O(changes log changes).
std::vector<Cause> symbol_causes(const model::PlantModel& before, const model::PlantModel& after,
                                 const std::vector<SymbolChange>& changes);
std::vector<Cause> device_causes(const model::PlantModel& before, const model::PlantModel& after,
                                 const std::vector<DeviceChange>& changes);

}  // namespace symplant::diff
