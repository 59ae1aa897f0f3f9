// Statistics of durations, and of the times between events.
#pragma once

#include <algorithm>
#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::trace {

/// Durations in ns. The mean is rounded down; all are 0 without a duration.
struct Durations {
  std::uint64_t count = 0;
  tables::Time sum = 0;
  tables::Time least = 0;
  tables::Time greatest = 0;
  tables::Time last = 0;

  constexpr void add(tables::Time duration) noexcept {
    least = count == 0 ? duration : std::min(least, duration);
    greatest = std::max(greatest, duration);
    last = duration;
    sum += duration;
    ++count;
  }
  constexpr tables::Time mean() const noexcept { return count == 0 ? 0 : sum / static_cast<tables::Time>(count); }
};

/// The times between events, in their order.
struct Intervals {
  std::uint64_t events = 0;
  tables::Time latest = 0;  ///< the time of the last event
  Durations between;        ///< one less than the events

  constexpr void add(tables::Time time) noexcept {
    if (events++ != 0) between.add(time - latest);
    latest = time;
  }
};

}  // namespace symplant::trace
