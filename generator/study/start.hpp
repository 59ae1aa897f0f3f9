// The state in which a recording begins.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "model/plant_model.hpp"
#include "observe/play.hpp"
#include "recording/recording.hpp"

namespace symplant::study {

using tables::Time;

struct Start {
  Time begin = 0;              ///< from when on the values of all symbols are known; the plant's time 0
  std::vector<double> values;  ///< by series
  std::vector<bool> known;     ///< by series: whether the recording has its value at `begin`
  std::vector<std::pair<std::uint32_t, std::uint8_t>> states;  ///< units that begin in another state than the model's
  std::vector<std::pair<std::uint32_t, double>> numbers;       ///< values that signals show, by PlantModel::values
  std::size_t unknown = 0;  ///< units with events whose events show no state: they begin in that of the model
};

/// O(plant + series).
Start start_of(const model::PlantModel& plant, const recording::Recording& recording, const observe::Matched& matched);

}  // namespace symplant::study
