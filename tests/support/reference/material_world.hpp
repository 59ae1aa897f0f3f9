// Parts on tracks and in places, as they change in the reference. Positions are in 10^-15 m.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/engine/instant.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::reference {

using tables::Time;

inline constexpr std::int64_t kMicrometer = 1'000'000'000;

struct PartWorld {
  std::uint64_t number = 0;
  std::uint32_t kind = 0;
  std::int64_t x0 = 0;  ///< its front at `t0`; parts in places have no position
  Time t0 = 0;
  std::int64_t v = 0;  ///< um/s, which is also 10^-15 m per ns

  std::int64_t x(Time time) const { return x0 + v * (time - t0); }
  void rebase(std::int64_t position, Time time) {
    x0 = position;
    t0 = time;
  }
};

struct TrackWorld {
  std::vector<PartWorld> parts;  ///< from the front
  bool frozen = false;
  // At the end of the last instant:
  std::vector<bool> held;    ///< stops
  std::vector<bool> facing;  ///< the boundary after each drive but the last
  Time own_due = tables::kNever;
  // The instants that its own parts caused:
  Time window = -1;      ///< the first one of the current window; -1: none so far
  int own_instants = 0;  ///< in the current window
};

/// A part that an end moved from one track to another, and that may still cover the end of the first one.
struct TailWorld {
  std::uint64_t number = 0;  ///< of the part
  std::uint32_t on = 0;      ///< the track that it left
  std::uint32_t to = 0;      ///< the track of its front
  Time left = 0;
};

struct TransferWorld {
  bool truth = false;  ///< of its `when` in the last round
  bool permission = false;
  bool moved = false;  ///< since its `when` began to hold
  bool frozen = false;
  bool blocked = false;  ///< the finding was true at the end of the last instant
};

struct WorkWorld {
  bool truth = false;  ///< of its `when` in the last round
  bool frozen = false;
};

struct SourceWorld {
  Time due = 0;
  std::uint64_t made = 0;
  std::uint32_t draws = 0;
  bool frozen = false;
};

struct MaterialWorld {
  std::vector<TrackWorld> tracks;
  std::vector<std::vector<PartWorld>> places;  ///< each in order of arrival
  std::vector<TransferWorld> transfers;
  std::vector<WorkWorld> work;
  std::vector<SourceWorld> sources;
  std::vector<TailWorld> tails;  ///< in the order in which the parts left
  std::uint64_t next_number = 1;
  std::vector<std::uint64_t> made;  ///< kinds
  std::vector<std::uint64_t> gone;
  Time due = tables::kNever;                ///< of sources and rooms, at the end of the last instant
  std::vector<engine::PartChange> by_hand;  ///< since the last instant

  const std::vector<PartWorld>& at(std::uint32_t location) const {
    return location < tracks.size() ? tracks[location].parts : places[location - tracks.size()];
  }
  std::vector<PartWorld>& at(std::uint32_t location) {
    return location < tracks.size() ? tracks[location].parts : places[location - tracks.size()];
  }
};

}  // namespace symplant::reference
