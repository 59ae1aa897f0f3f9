// The parts of the flat block, except the planes and the units.
#pragma once

#include <cstdint>

#include "symplant/engine/wheel.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {

/// The head of the flat block; the arrays of the changing state follow it. The block has no pointers and may be copied.
struct BlockHead {
  std::uint64_t magic;
  std::uint64_t model;  ///< model_hash of the plant whose state this is
  std::uint64_t size;   ///< of the block, in bytes
  std::uint64_t seed;
  tables::Time cycle;
  tables::Time now;
  std::uint32_t waits;  ///< kNotStarted, kActed, kMayChange; 0: only what is due and what is written changes it
  std::uint32_t unused;
  std::uint64_t shown;         ///< 1: the initial events were reported before the first instant
  std::uint64_t event_forces;  ///< number of forced BOOL events
  Wheel wheel;
};

/// BlockHead::waits
enum : std::uint32_t {
  kNotStarted = 1 << 0,  ///< the first instant, at time 0, has not run yet
  kActed = 1 << 1,       ///< an outside action (force, set_state, ...) happened since the last instant
  kMayChange = 1 << 2,   ///< constant: the plant has written malfunctions
};

/// A word of BOOL operations, in addition to its levels.
struct OperationWord {
  std::uint64_t written;   ///< as the PLC wrote them; sampled by the next instant that samples
  std::uint64_t served;    ///< those that were served since they rose
  std::uint64_t reported;  ///< those that had a finding when they rose
  std::uint64_t waiting;   ///< 1: written since it was sampled last
};

/// The changing state of a general unit in addition to its UnitState.
struct GeneralState {
  tables::Time whole;         ///< travel time of the current move
  std::uint32_t disabled_by;  ///< how many (unit, state) pairs disable it now
  std::uint8_t position;  ///< as last published: the state in which it is settled, or kMovingState; at first kNoState
  std::uint8_t counted;   ///< 1: its disabled_by changed in this round
};

/// The state of a `timed` transition.
struct Record {
  tables::Time ready;   ///< if its cause holds: when it has held long enough; in a halted unit the time left
  std::uint32_t draws;  ///< random numbers drawn so far
  std::uint32_t holds;  ///< 1: its cause holds; valid if UnitState::holding, for transitions from the unit's state
};

struct MonitorState {
  tables::Time started;  ///< valid if `running`
  std::uint32_t running;
  std::uint32_t held;  ///< 1: its condition held at the end of the last instant
};

/// The commands to the state that a held unit has reached (docs/model.md, overrun).
struct OverrunState {
  std::uint64_t commands;  ///< the operations that were on, and led to `state`, at the end of the last instant
  std::uint32_t state;     ///< in which it was settled then
  std::uint32_t found;     ///< 1: the finding was true at the end of the last instant
};

/// FollowState::frozen
inline constexpr std::uint8_t kFrozenBefore = 1;
inline constexpr std::uint8_t kFrozenInThisInstant = 2;

/// More instants caused by the parts of one track, or more starts and ends of malfunctions, within kLoopWindow are a
/// loop.
inline constexpr std::uint32_t kMostInLoopWindow = 10'000;
inline constexpr tables::Time kLoopWindow = tables::kMillisecond;

struct FollowState {
  std::uint8_t frozen;  ///< 0: it is not
  std::uint8_t steps;   ///< as UnitState::steps
};

struct BehaviourState {
  tables::Time wake;  ///< when woken() is due, or kNever; in a halted unit the time left
  std::uint32_t draws;
  std::uint16_t woken;  ///< 1: `wake` has been reached, and the unit has not stepped since
  std::uint16_t ill;    ///< 1: the link of its operations is lost
};

/// Bits of a condition's state: its inputs, its truth as last published, and whether it waits for evaluation.
inline constexpr std::uint8_t kInputs = 0x3F;
inline constexpr std::uint8_t kTruth = 0x40;
inline constexpr std::uint8_t kWaiting = 0x80;

}  // namespace symplant::engine
