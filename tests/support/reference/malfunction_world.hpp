// What changes in the malfunctions of the reference's plant.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "symplant/engine/instant.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::reference {

/// An effect of a written malfunction.
struct EffectWorld {
  tables::Time flickers = tables::kNever;
  bool shows_opposite = false;
  std::uint32_t draws = 0;          ///< of `every`
  std::vector<std::uint64_t> held;  ///< what its forces hold, in their order; 0 if they do not
};

/// A written malfunction. Times are absolute; kNever: none runs.
struct MalfunctionWorld {
  bool active = false;
  tables::Time since = 0;  ///< 0 if it is not active
  tables::Time chance = tables::kNever;
  tables::Time ends = tables::kNever;
  tables::Time becomes = tables::kNever;
  bool truth = false;                 ///< of `when` or `while`, at the end of the last instant
  bool stopped = false;               ///< `while`: stopped from outside; until the condition does not hold
  tables::Time by_condition_at = -1;  ///< its last start by `when`
  bool wants_start = false;           ///< in a further instant at the same time
  bool wants_end = false;
  std::array<std::uint32_t, 2> draws{};
  std::vector<EffectWorld> effects;
  std::size_t begun = 0;  ///< active: this number of its effects have begun
  int changes = 0;        ///< its starts and ends in the current window
  bool frozen = false;    ///< it was in an instantaneous loop

  tables::Time next_due() const {
    tables::Time due = active ? std::min(ends, becomes) : chance;
    for (std::size_t i = 0; i < begun; ++i) due = std::min(due, effects[i].flickers);
    return due;
  }
};

/// Of any kind, by its number.
struct ActiveWorld {
  std::uint32_t number = 0;
  tables::Time since = 0;
};

struct MalfunctionsWorld {
  std::vector<MalfunctionWorld> written;
  std::vector<ActiveWorld> active;                 ///< in the order in which they started
  bool pending = false;                            ///< a further instant must make changes
  tables::Time window = -1;                        ///< the first change in the current window; -1: none so far
  int changes = 0;                                 ///< starts and ends of written ones in the current window
  std::vector<engine::MalfunctionChange> by_hand;  ///< since the last instant
};

}  // namespace symplant::reference
