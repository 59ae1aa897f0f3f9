// Makes a recording of changes.
#pragma once

#include <cstdint>
#include <vector>

#include "model/plant_model.hpp"
#include "recording/recording.hpp"

namespace symplant::property {

/// Collects the values of a plant's symbols. Calls are in the order of time.
class Recorder {
 public:
  /// Times are exact to `resolution`; 0: a trace of the plant in virtual time.
  Recorder(const model::PlantModel& plant, tables::Time resolution);

  /// Notes the value of a symbol; only changes are kept. O(1).
  void note(tables::Time time, std::uint32_t symbol, double value);
  /// Nothing is known of [begin, begin + length). O(1).
  void gap(tables::Time begin, tables::Time length) { recording_.gaps.push_back({begin, length}); }
  recording::Recording finish(tables::Time end);

 private:
  const model::PlantModel& plant_;
  recording::Recording recording_;
  std::vector<std::uint32_t> series_;  ///< by symbol; kNone: not noted yet
};

}  // namespace symplant::property
