// How often an event would follow an operation by chance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "learn/follow.hpp"

namespace symplant::learn {

inline constexpr std::size_t kTrials = 100;

/// Hits of changes whose times are shifted by random offsets.
struct Chance {
  std::size_t changes = 0;  ///< those that are examined
  std::size_t hits = 0;     ///< of these, with their own times
  std::size_t most = 0;     ///< the most hits of all trials
  double mean = 0;

  bool passed() const { return most < hits; }
};

/// In each of kTrials trials, every change of the operation gets another time, up to two of their distances away.
/// One offset for all changes would fail in a plant whose cycles are equally long: shifted by a cycle, everything fits
/// again. At most 64 changes are examined. `pair`: identifies the pair, so that its random numbers do not depend on
/// others. O(kTrials * log(changes)).
Chance chance_of(const Edges& operation, const Edges& event, const Follows& follows, const Timeline& timeline,
                 std::uint64_t seed, std::uint64_t pair);

}  // namespace symplant::learn
