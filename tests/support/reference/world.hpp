// All that changes in the reference's plant: plain values, copied whole in every round.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "symplant/tables/time.hpp"

namespace symplant::reference {

using tables::Time;

inline constexpr std::uint16_t kNoTransition = 0xFFFF;  ///< under way: settled, or a way without a command

struct TransitionWorld {
  bool holds = false;  ///< its cause holds and it remembers that
  Time left = 0;       ///< of its `after`
  std::uint32_t draws = 0;
};

struct OperationWorld {
  bool armed = true;
  bool served = false;       ///< since its rise
  bool had_finding = false;  ///< when it rose
  bool reached = false;  ///< at the end of an instant since its rise its unit was in, or moving to, a state it leads to
};

struct UnitWorld {
  std::uint8_t state = 0;   ///< settled in, or moving from
  std::uint8_t target = 0;  ///< moving to; `state` where it is settled
  bool moving = false;
  bool stopped_midway = false;  ///< moving, but standing still
  bool disabled = false;
  bool frozen = false;
  bool automatic = false;  ///< the move under way is an automatic one
  std::uint16_t moving_now = kNoTransition;
  Time remaining = 0;
  Time whole = 0;
  std::uint8_t shown_settled = 0xFF;  ///< at the end of the last instant: the state settled in, 0xFF where in none
  bool shown_moving = false;
  std::vector<TransitionWorld> transitions;
  std::vector<OperationWorld> operations;
  bool conflicting = false;  ///< the findings that were true at the end of the last instant
  bool stopped = false;
  std::uint32_t own_draws = 0;
  Time until_woken = -1;              ///< -1: not at all
  std::vector<std::uint64_t> memory;  ///< of its behaviour
};

struct SymbolWorld {
  std::uint64_t written = 0;  ///< operations: last written, perhaps not yet sampled
  std::uint64_t value = 0;    ///< operations: as last sampled; events: as made or set; before forces
  bool forced = false;
  std::uint64_t forced_value = 0;
  std::uint64_t shown = 0;  ///< the effective value at the end of the last instant
  Time rose = 0;            ///< the instant at whose end it was last seen to have risen
};

struct MonitorWorld {
  bool running = false;
  Time deadline = 0;
  bool truth = false;
};

struct World {
  Time time = 0;
  std::uint64_t seed = 0;
  Time cycle = 0;
  bool instant_pending = true;   ///< the first instant, or one with what was done from outside, is still to run here
  bool link_well = true;         ///< what behaviours see as their link's quality
  bool written_pending = false;  ///< something was written that no instant has sampled yet
  std::vector<UnitWorld> units;
  std::vector<SymbolWorld> symbols;
  std::vector<MonitorWorld> monitors;
};

}  // namespace symplant::reference
