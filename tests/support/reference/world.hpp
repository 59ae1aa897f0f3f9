// All that changes in the reference's plant: simple values, copied whole in every round.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/reference/malfunction_world.hpp"
#include "support/reference/material_world.hpp"
#include "support/reference/value_world.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::reference {

using tables::Time;

inline constexpr std::uint16_t kNoTransition = 0xFFFF;  ///< of a move: settled, or without a command

struct TransitionWorld {
  bool holds = false;  ///< its cause holds, and this is remembered
  Time left = 0;       ///< of its `after`
  std::uint32_t draws = 0;
};

struct OperationWorld {
  bool armed = true;
  bool served = false;       ///< since its rise
  bool had_finding = false;  ///< when it rose
  Time at_end_since = -1;    ///< on, and its unit settled in `at_end`, since the end of this instant; -1: no
  std::uint8_t at_end = 0xFF;
  bool reached = false;  ///< since its rise its unit was, at the end of an instant, in or moving to a state it leads to
};

struct UnitWorld {
  std::uint8_t state = 0;   ///< settled in, or moving from
  std::uint8_t target = 0;  ///< moving to; equal to `state` if settled
  bool moving = false;
  bool stopped_midway = false;  ///< moving, but stopped
  bool disabled = false;
  bool disabled_by_units = false;  ///< as last worked out; it may be stuck as well
  bool frozen = false;
  bool automatic = false;         ///< the current move is automatic
  bool returning = false;         ///< the current move has turned round
  bool stopped_by_while = false;  ///< the reason of `stopped_midway`
  std::uint16_t moving_now = kNoTransition;
  Time remaining = 0;
  Time whole = 0;
  std::uint8_t shown_settled = 0xFF;  ///< at the end of the last instant: the settled state, 0xFF if none
  bool shown_moving = false;
  std::vector<TransitionWorld> transitions;
  std::vector<OperationWorld> operations;
  bool conflicting = false;  ///< the findings that were true at the end of the last instant
  bool stopped = false;
  bool overrun = false;
  std::uint32_t own_draws = 0;
  Time until_woken = -1;              ///< -1: never
  std::vector<std::uint64_t> memory;  ///< of its behavior
};

/// What malfunctions make of a symbol, below the user's force.
struct SymbolOverride {
  enum class Kind : std::uint8_t { none, value, opposite };
  Kind kind = Kind::none;
  std::uint64_t value = 0;
};

struct SymbolWorld {
  std::uint64_t written = 0;  ///< operations: last written, perhaps not yet sampled
  std::uint64_t value = 0;    ///< operations: as last sampled; events: as made or set; before forces
  SymbolOverride broken;
  bool forced = false;
  std::uint64_t forced_value = 0;
  std::uint64_t shown = 0;  ///< the effective value at the end of the last instant
  /// The instant at whose end its last rise in a run with a cycle was seen.
  Time rose = -tables::kNever / 2;
};

struct MonitorWorld {
  bool running = false;
  Time started = 0;
  Time deadline = 0;
  bool truth = false;
};

struct Rules;

struct World {
  const Rules* rules = nullptr;  ///< of the plant, for conditions
  Time time = 0;
  std::uint64_t seed = 0;
  Time cycle = 0;
  Time last_instant = -1;        ///< of the last instant that ran; -1: none since the reset
  bool instant_pending = true;   ///< the first instant, or one with external actions, is still to run here
  bool link_well = true;         ///< the link quality that behaviors see
  bool written_pending = false;  ///< a written value has not been sampled yet
  std::vector<UnitWorld> units;
  std::vector<SymbolWorld> symbols;
  std::vector<MonitorWorld> monitors;
  std::vector<bool> frozen_follows;  ///< as Rules::follows
  MaterialWorld material;
  MaterialWorld shown_material;  ///< at the end of the last instant
  MalfunctionsWorld malfunctions;
  std::vector<ValueWorld> values;    ///< as Rules::values
  std::vector<SignalWorld> signals;  ///< as Rules::signals
};

}  // namespace symplant::reference
