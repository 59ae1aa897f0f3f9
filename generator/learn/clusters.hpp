// Sorts durations into groups that gaps divide.
#pragma once

#include <vector>

#include "learn/learned.hpp"

namespace symplant::learn {

/// `samples` are sorted by duration. A gap divides if it is over 30 % of the median and at least 5 resolutions. A group
/// with one duration, or with under 5 % of them, is left out if larger ones remain. O(samples).
Clusters clusters_of(const std::vector<Sample>& samples, Time resolution);

/// The durations of all groups that are kept, sorted.
std::vector<Time> kept_durations(const std::vector<Sample>& samples, const Clusters& clusters);

}  // namespace symplant::learn
