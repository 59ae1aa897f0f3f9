// The score of each list, line, station and device.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "score/score.hpp"

namespace symplant::score {

enum class Level : std::uint8_t {
  list,
  line,
  station,  ///< line and process
  device,   ///< line, process and device
};

/// A list, or what the first levels of names say. Symbols whose names have no levels are in one part without names.
struct Part {
  std::uint32_t list = 0;  ///< index in PlantModel::lists; of Level::list only
  std::string_view line = {};
  std::string_view process = {};
  std::string_view device = {};
  Counts counts = {};

  /// `LINE_PROC_DEV`, without empty levels.
  std::string path() const;
};

/// The parts of a level that have counted symbols, in the order of their first one; of Level::list all. O(symbols).
std::vector<Part> parts_of(const model::PlantModel& plant, const PlantScore& score, Level level);

}  // namespace symplant::score
