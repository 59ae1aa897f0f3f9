// How exact the times of a recording are, by its rows.
#pragma once

#include <vector>

#include "recording/recording.hpp"

namespace symplant::recording {

/// What the distances between the times of successive rows show.
struct Steps {
  tables::Time resolution = 0;  ///< 0: fewer than two times
  bool regular = false;         ///< 95 % of the distances are the resolution, up to 10 %
};

/// If at least half of the distances are their median, up to 10 %, the rows are readings, and the median is the
/// interval. Otherwise a row is written when something changes: then it is the smallest distance that 5 % of all have,
/// up to 10 %. `times` must not decrease. O(times * log(times)).
Steps steps_of(const std::vector<tables::Time>& times);

/// The times in which regular rows are missing: from one row to the next, if that is over 3 resolutions.
std::vector<Gap> gaps_in(const std::vector<tables::Time>& times, tables::Time resolution);

}  // namespace symplant::recording
