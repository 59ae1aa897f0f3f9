// Counts durations for a picture.
#pragma once

#include <cstdint>
#include <vector>

#include "learn/learned.hpp"

namespace symplant::learn {

/// Durations in intervals of equal width: the interval i is [from + i * step, from + (i + 1) * step). The middle of an
/// interval is a multiple of the width. The first one may begin below 0.
struct Histogram {
  Time from = 0;
  Time step = 1;
  std::vector<std::uint32_t> counts;    ///< of used durations
  std::vector<std::uint32_t> outliers;  ///< those outside are in the first or last interval
};

/// At most 60 intervals, of a width that the resolution allows, around the used durations and the proposed time. The
/// model's time is included if it is no more than three times as far. O(samples).
Histogram histogram_of(const LearnedTime& time, const description::Duration& model);

}  // namespace symplant::learn
