// Finds which operations an event may follow, from a sample of their changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "learn/timeline.hpp"

namespace symplant::learn {

/// Changes of a symbol in one direction.
struct EdgeOf {
  std::uint32_t symbol;
  bool on;
};

/// For each of `events`, which changes of operations may cause its changes to on, 16 at most: those after which the
/// delays are the most constant, and the last ones before the event.
/// O(operations * 8 * changes of events within kLongestDelay).
std::vector<std::vector<EdgeOf>> candidates_of(const std::vector<std::uint32_t>& operations,
                                               const std::vector<std::uint32_t>& events, const Timeline& timeline);

}  // namespace symplant::learn
