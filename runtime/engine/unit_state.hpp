// The changing state of a unit, and its flags.
#pragma once

#include <cstdint>

#include "symplant/engine/engine_index.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {

/// All bits zero: a unit settled in state 0, not in the wheel. Times are absolute. While a unit is disabled, frozen or
/// stopped midway they are the time left.
struct UnitState {
  tables::Time due;    ///< moving: when it arrives; settled and in the wheel: when the first cause has held long enough
  std::uint32_t next;  ///< in its bucket of the wheel
  std::uint32_t previous;
  std::uint16_t transition;  ///< of the current move; kNoTransition if settled, or in a move without a command
  std::uint8_t state;        ///< in which it is settled, or from which it moves
  std::uint8_t target;       ///< to which it moves; `state` if it is settled
  std::uint16_t flags;
  std::uint8_t holding;  ///< 1: settled, and the record of at least one transition from `state` has a cause that holds
  /// Counted while loops are searched, up to kLoopSteps. Of a unit that was frozen in this instant: its loop's number.
  std::uint8_t steps;
};
static_assert(sizeof(UnitState) == 24);

/// UnitState::flags
enum : std::uint16_t {
  kMoving = 1 << 0,
  kMidway = 1 << 1,   ///< moving, but stopped midway
  kTimed = 1 << 2,    ///< has an entry in the wheel
  kQueued = 1 << 3,   ///< will step in the next round
  kTouched = 1 << 4,  ///< is in touched_: the end of the instant processes it
  kDriven = 1 << 5,   ///< a general unit whose state is published when the round ends
  kDisabled = 1 << 6,
  kFrozen = 1 << 7,
  kEnabledNow = 1 << 8,         ///< was enabled in this instant
  kConflict = 1 << 9,           ///< conflicting operations
  kConflictReported = 1 << 10,  ///< had kConflict at the end of the last instant
  kStopped = 1 << 11,           ///< stopped under another command
  kStoppedReported = 1 << 12,   ///< had kStopped at the end of the last instant
  kSlowed = 1 << 13,            ///< a malfunction slows its moves, or did so when its last one began
  kGeneral = 1 << 14,           ///< UnitRow::general, of a type that is not plain, or kSlowed: never on the fast path
  kBehaves = 1 << 15,           ///< constant: has a custom behavior
};
/// A unit with this number of steps in the second half of the rounds before a search for loops is in a loop.
inline constexpr std::uint8_t kLoopSteps = 3;
/// A unit with one of these flags makes no step, and its times do not run.
inline constexpr std::uint16_t kHalted = kDisabled | kFrozen;

}  // namespace symplant::engine
