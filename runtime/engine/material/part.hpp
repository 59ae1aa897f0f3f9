// A part on a track, and the arithmetic of its motion.
//
// Positions are counted in 10^-15 m: a speed of 1 um/s covers exactly one such unit in 1 ns, so that motion needs no
// rounding.
#pragma once

#include <cstdint>
#include <limits>

#include "symplant/tables/time.hpp"

namespace symplant::engine {

/// In units of 10^-15 m. A track of 1 km has 10^18 of them.
using Position = std::int64_t;

inline constexpr Position kMicrometer = 1'000'000'000;
inline constexpr Position kBeyond = std::numeric_limits<Position>::max();

/// A part on a track: its front is at x0 + v * (t - t0).
struct Part {
  Position x0;
  tables::Time t0;
  Position aim;            ///< the next front position at which it is put exactly, in its direction; or +-kBeyond
  tables::Time mark_due;   ///< when its coverage of a sensor or of a transfer's position changes
  tables::Time speed_due;  ///< when something happens that may change a speed
  std::uint64_t number;
  tables::Time since;  ///< when it came to the track
  std::int32_t v;      ///< um/s, which is units/ns; < 0: backward
  std::uint32_t kind;
  std::uint32_t drive;  ///< of the track: the one whose range has its middle
  std::uint32_t front;  ///< the number of marks at or behind its front
  std::uint32_t tail;   ///< the number of marks behind its tail: it covers the marks from `tail` to before `front`
  std::uint32_t stale;  ///< 1: its due times must be computed again

  Position at(tables::Time now) const noexcept { return x0 + v * (now - t0); }
  void base(Position x, tables::Time now) noexcept {
    x0 = x;
    t0 = now;
    stale = 1;
  }
};

/// Whole ns until a distance >= 0 has been covered at a speed > 0.
constexpr tables::Time time_to_reach(Position distance, Position speed) noexcept {
  return (distance + speed - 1) / speed;
}
/// Whole ns until more than a distance >= 0 has been covered.
constexpr tables::Time time_to_pass(Position distance, Position speed) noexcept { return distance / speed + 1; }

}  // namespace symplant::engine
