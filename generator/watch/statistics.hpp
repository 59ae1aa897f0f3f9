// What moves took on average when the plant was learned.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/plant_model.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::watch {

/// The time from a cause to leaving, from leaving to arriving, or from a cause to arriving.
enum class Span : std::uint8_t { after, takes, total };

struct Statistic {
  std::uint32_t unit = 0;
  std::uint32_t from = 0;  ///< states
  std::uint32_t to = 0;
  std::uint32_t on = model::kNone;  ///< index in Unit::operations; kNone: by whatever cause
  Span span = Span::takes;
  std::uint64_t n = 0;
  double mean = 0;       ///< ns
  double deviation = 0;  ///< standard, ns
};

struct ReadStatistics {
  std::vector<Statistic> statistics;
  std::string error;  ///< `FILE:4: ...`; empty: the file could be read
};

/// The key `learned` of a file that `symplant learn` wrote. What a device or a move of another plant has is left out.
/// O(text + units).
ReadStatistics read_statistics(std::string_view text, const std::string& name, const model::PlantModel& plant);

}  // namespace symplant::watch
