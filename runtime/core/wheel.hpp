// When units become due: an exact monotone radix wheel, 64-way, with one intrusive entry a unit.
//
// A bucket is chosen by the highest group of six bits in which a due time differs from `last`, and by the due time's
// digit in that group (a radix heap: Ahuja, Mehlhorn, Orlin, Tarjan, "Faster algorithms for the shortest path problem",
// 1990). As time goes on a bucket is cut into lower ones; a unit moves down at most once a group, so that arming and
// expiry cost O(1) amortised whatever the number of units.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "symplant/core/time.hpp"

namespace symplant::core {

/// What changes in one unit. All bits zero is a unit settled in state 0, in no wheel.
struct UnitState {
  Time due;            ///< in the wheel: when it becomes due; standing still: the time remaining
  Time mark;           ///< settled: since when; moving: the whole time of the move
  std::uint32_t next;  ///< in its bucket
  std::uint32_t previous;
  std::uint16_t transition;  ///< under way; kNoTransition on a spring's way without a command
  std::uint8_t state;        ///< settled in, or moving from
  std::uint8_t target;       ///< moving to
  std::uint8_t flags;
};
static_assert(sizeof(UnitState) == 32);

inline constexpr std::uint16_t kNoTransition = 0xFFFF;

/// UnitState::flags
inline constexpr std::uint8_t kMoving = 1;
inline constexpr std::uint8_t kStanding = 2;  ///< moving, but its time stands still
inline constexpr std::uint8_t kTimed = 4;     ///< has an entry in the wheel
inline constexpr std::uint8_t kQueued = 8;    ///< will step in the coming round
inline constexpr std::uint8_t kStepped = 16;  ///< made a step in this instant

/// Lies in the flat block: indices only.
class Wheel {
 public:
  static constexpr std::uint32_t kNone = 0xFFFF'FFFF;

  void clear() noexcept;

  /// `due` must not lie before any time that expired() has given.
  void insert(UnitState* units, std::uint32_t unit, Time due) noexcept;
  void remove(UnitState* units, std::uint32_t unit) noexcept;

  /// The earliest due time up to and including `limit`, or kNever. Nothing before `limit` may be inserted afterwards
  /// that lies before what this gives (or before `limit`, where it gives kNever).
  Time earliest(UnitState* units, Time limit) noexcept;
  /// The earliest due time of all, or kNever; changes nothing. O(units of one bucket).
  Time peek(const UnitState* units) const noexcept;

  /// Takes all units due at `time`, which earliest() has just given, out of the wheel: the first of them, chained by
  /// `next`, their kTimed flags still set.
  std::uint32_t take(Time time) noexcept;

 private:
  static constexpr std::size_t kLevels = 11;  // 63 bits in groups of six

  std::uint32_t bucket_of(Time due) const noexcept;
  void link(UnitState* units, std::uint32_t unit) noexcept;
  void redistribute(UnitState* units, std::uint32_t level, std::uint32_t digit) noexcept;
  std::uint32_t lowest_level() const noexcept;
  std::uint32_t lowest_digit(std::uint32_t level) const noexcept;
  Time bucket_minimum(const UnitState* units, std::uint32_t bucket) const noexcept;

  Time last_;             ///< no entry lies before it
  Time bound_;            ///< nor before this: an idle look costs one compare
  std::uint64_t levels_;  ///< bit l: occupied_[l] is not empty
  std::array<std::uint64_t, kLevels> occupied_;
  std::array<std::uint32_t, kLevels * std::size_t{64}> heads_;
};

}  // namespace symplant::core
