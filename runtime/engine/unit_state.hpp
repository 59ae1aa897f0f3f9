// What changes in every unit, and the flags that say what it is about.
#pragma once

#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::engine {

inline constexpr std::uint16_t kNoTransition = 0xFFFF;

/// All bits zero is a unit settled in state 0, in no wheel. Times are absolute, but of a unit whose time stands still
/// (disabled, frozen, or standing midway) they are what is left.
struct UnitState {
  tables::Time due;    ///< moving: when it arrives; settled and in the wheel: when the first cause has held long enough
  tables::Time whole;  ///< of the move under way
  std::uint32_t next;  ///< in its bucket of the wheel
  std::uint32_t previous;
  std::uint16_t transition;  ///< under way; kNoTransition on a spring's way without a command
  std::uint8_t state;        ///< settled in, or moving from
  std::uint8_t target;       ///< moving to; `state` where it is settled
  std::uint16_t flags;
  std::uint8_t holding;  ///< 1: some transition's record says that its cause holds
  std::uint8_t steps;    ///< in the second half of many rounds, up to 3; of a frozen unit the number of its loop
};
static_assert(sizeof(UnitState) == 32);

/// UnitState::flags
enum : std::uint16_t {
  kMoving = 1 << 0,
  kMidway = 1 << 1,   ///< moving, but standing still midway
  kTimed = 1 << 2,    ///< has an entry in the wheel
  kQueued = 1 << 3,   ///< will step in the coming round
  kTouched = 1 << 4,  ///< is looked at when the instant ends
  kDriven = 1 << 5,   ///< a rich unit whose state others must be told of when the round ends
  kDisabled = 1 << 6,
  kFrozen = 1 << 7,
  kEnabledNow = 1 << 8,         ///< was enabled in this instant
  kConflict = 1 << 9,           ///< conflicting operations
  kConflictReported = 1 << 10,  ///< likewise, at the end of the last instant
  kStopped = 1 << 11,           ///< stopped under another command
  kStoppedReported = 1 << 12,
  kFrozenNow = 1 << 13,  ///< was frozen in this instant
  kGeneral = 1 << 14,    ///< always: rich, or of a type that is not plain
  kBehaves = 1 << 15,    ///< always: has a behaviour's code
};
/// Its times stand still and it makes no step.
inline constexpr std::uint16_t kHalted = kDisabled | kFrozen;

}  // namespace symplant::engine
