// When the BOOL symbols of recordings change, on one axis of time.
#pragma once

#include <cstdint>
#include <vector>

#include "learn/input.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::learn {

using tables::Time;

/// The longest time from the change of an operation to that of an event which follows it.
inline constexpr Time kLongestDelay = 30 * tables::kSecond;

/// A time in which a recording has no gap.
struct Stretch {
  Time begin;
  Time end;
};

/// The values of one symbol.
struct Track {
  struct Value {
    Time time;
    bool on;
  };
  std::vector<Value> values;  ///< by time: each differs from the one before; off before the first
  std::vector<Time> rises;    ///< changes that were seen, by time
  std::vector<Time> falls;
};

/// Recordings one after the other. What is known only after a gap, or at the beginning, is a value and no change.
struct Timeline {
  std::vector<Stretch> stretches;  ///< by time
  std::vector<Track> tracks;       ///< by symbol of the plant
  Time resolution = 0;             ///< the coarsest of the recordings

  /// The stretch of a change. O(log stretches).
  const Stretch& stretch_of(Time time) const;
  Time length() const;  ///< of all stretches
};

/// `symbols`: how many the plant has. O(changes).
Timeline timeline_of(const std::vector<Input>& inputs, std::size_t symbols);

}  // namespace symplant::learn
