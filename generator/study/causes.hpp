// Which operations move what a signal shows.
#pragma once

#include <cstdint>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::study {

/// By index in PlantModel::signals: the operations that its number depends on, by values, devices and conditions, but
/// not by parts; ascending. O(signals * what they depend on).
std::vector<std::vector<std::uint32_t>> operations_of_signals(const model::PlantModel& plant);

}  // namespace symplant::study
