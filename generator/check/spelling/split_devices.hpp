// Devices that were divided by two spellings of their line or process.
#pragma once

#include <cstdint>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::check {

/// Two units whose names differ in one level and that complement each other.
struct SplitDevice {
  name::Level level{};      ///< line or process
  std::uint32_t part = 0;   ///< index in PlantModel::units: its symbols are just those that `whole` lacks
  std::uint32_t whole = 0;  ///< index in PlantModel::units
};

/// Finds units that have just the operations or events that another one lacks: two of them or more, or one where the
/// other unit has a task with both. Lines may differ in anything, processes in more than their digits. Each unit is in
/// one pair at most; if several fit, there is none. O(symbols).
std::vector<SplitDevice> split_devices(const model::PlantModel& plant);

}  // namespace symplant::check
