// The material flow of a plant: moves parts on tracks and between locations, and sets their sensors.
//
// It takes part in the engine's rounds (docs/model.md, "One instant"; docs/material.md). A part's position follows from
// its speed, so that a part that moves freely costs nothing between two marks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/block.hpp"
#include "symplant/engine/dirty_set.hpp"
#include "symplant/engine/instant.hpp"
#include "symplant/engine/material/flow_index.hpp"
#include "symplant/engine/material/part.hpp"
#include "symplant/engine/round_marks.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::engine {

class Engine;

/// The changing state of a track in addition to its parts.
struct TrackState {
  tables::Time room_due;      ///< when room may appear for a part that waits for it, or the order of tails changes
  tables::Time window_begin;  ///< of the millisecond in which `instants` are counted
  std::uint32_t instants;     ///< that its own parts caused in that time
  std::uint32_t size;         ///< the number of its parts
  std::uint32_t waiting_kind;
  std::uint32_t tail_on;    ///< 1 + the track from whose end the last part came, which it may still cover; 0: none
  std::uint32_t tail_mark;  ///< of that track: the tail covers the marks from this one on
  std::uint8_t waiting;     ///< 1: its end waits for room, for a part of `waiting_kind`
  std::uint8_t frozen;      ///< as FollowState::frozen
  std::uint8_t freezing;    ///< 1: it is frozen before the rounds of this instant
  std::uint8_t loop;        ///< number of its loop in the instant in which it is frozen
  std::uint8_t stale;       ///< 1: the due times of all its parts must be computed again
  std::uint8_t unused[7];
};

struct PlacePart {
  std::uint64_t number;
  tables::Time since;
  std::uint32_t kind;
  std::uint32_t unused;
};

struct PlaceState {
  std::uint32_t begin;  ///< of its parts, which are a ring: the one that came first
  std::uint32_t size;
};

struct TransferState {
  std::uint8_t began;       ///< its condition held in the last round that looked
  std::uint8_t permission;  ///< `once`: it may move a part
  std::uint8_t moved;       ///< it has moved a part since its condition began to hold
  std::uint8_t frozen;      ///< as FollowState::frozen
  std::uint8_t steps;       ///< as FollowState::steps
  std::uint8_t blocked;     ///< the finding `part blocked` was true at the end of the last instant
  std::uint8_t waiting;     ///< 1: it waits for room, for a part of `waiting_kind`
  std::uint8_t unused;
  std::uint32_t waiting_kind;
};

struct WorkState {
  std::uint8_t began;
  std::uint8_t frozen;
  std::uint8_t steps;
  std::uint8_t unused;
};

struct SourceState {
  tables::Time due;  ///< kNever: it makes no further part
  std::uint64_t made;
  std::uint32_t draws;
  std::uint32_t waiting;  ///< 1: it waits for room
};

struct KindState {
  std::uint64_t made;
  std::uint64_t gone;
};

/// The part that a transfer, an end or a hand would move.
struct Candidate {
  std::uint32_t index = tables::kNone;  ///< among the parts of the location; kNone: there is none
  std::uint32_t kind = 0;
};

class Flow {
 public:
  // build() and place() set all other members.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  explicit Flow(Engine& engine) noexcept : engine_(engine) {}

  // Memory (flow_memory.cpp). The calls are in this order.
  void build(Arena& arena) noexcept;  ///< the look-ups
  void place(Arena& arena) noexcept;  ///< what is outside the flat block
  void place_block(Arena& arena, std::uint32_t first_entry) noexcept;
  void reset() noexcept;
  std::uint32_t wheel_entries() const noexcept;
  /// Looks at everything in the next round, as in the first one. O(material).
  void mark_all() noexcept;

  bool active() const noexcept { return active_; }
  /// Whether the next round has work to do.
  bool due() const noexcept { return due_; }
  /// Called by the engine before the rounds of an instant, or while one round is published to the next.
  void entry_due(std::uint32_t entry) noexcept;
  void condition_changed(tables::ReaderKind kind, std::uint32_t reader) noexcept;
  void value_changed(tables::Direction direction, std::uint32_t slot) noexcept;
  /// Of a value; O(log drives) if none reads it.
  void output_changed(std::uint32_t output) noexcept;
  /// The drives of a track have other speeds.
  void drives_changed(std::uint32_t track) noexcept;
  void begin_rounds() noexcept;
  /// One round, after the units' steps. `counting`: counts the steps of transfers and work.
  void round(bool counting) noexcept;
  void publish_counters() noexcept;

  // Loops and findings (flow_round.cpp).
  void forget_steps() noexcept;
  /// Whether a transfer or work acted too often.
  bool has_loop() const noexcept;
  void freeze_loop(std::uint8_t loop) noexcept;
  /// Calls `function(member, loop)` for each track, transfer and work frozen in this instant; they are numbered from
  /// `first`.
  template <class Function>
  void for_frozen_now(std::uint32_t first, Function function) const noexcept;
  void close_loops() noexcept;
  /// Collects the transfers that began to be blocked in this instant.
  void close_blocked(List<std::uint32_t>& begun) noexcept;
  void hash(tables::Fnv1a64& hash) const noexcept;
  void hash_blocked(tables::Fnv1a64& hash) const noexcept;
  std::span<const PartChange> changes() const noexcept { return changes_.view(); }
  /// The tracks whose parts came, left or changed their speeds in this instant, in no order.
  std::span<const std::uint32_t> moved_tracks() const noexcept { return moved_tracks_.list.view(); }
  void forget_changes() noexcept {
    changes_.size = 0;
    moved_tracks_.clear();
  }

  // For Plant, whose comments define it.
  bool put(const tables::PartLocation& to, std::uint32_t kind) noexcept;
  bool take(const tables::PartLocation& from) noexcept;
  std::uint32_t parts(std::uint32_t location) const noexcept;
  /// Of a PartCounterRow.
  std::uint64_t count(std::uint32_t counter) const noexcept { return counts_[counter]; }
  /// The sum of the weights of a location's parts, from 0 and from the front-most part on. O(parts).
  double weight(std::uint32_t location) const noexcept;
  const Part& part_on(std::uint32_t track, std::uint32_t index) const noexcept { return part(track, index); }
  const PlacePart& part_in(std::uint32_t place, std::uint32_t index) const noexcept;
  const KindState& kind(std::uint32_t kind) const noexcept { return kinds_[kind]; }
  bool is_frozen_track(std::uint32_t track) const noexcept { return tracks_[track].frozen != 0; }
  const TransferState& transfer(std::uint32_t transfer) const noexcept { return transfers_[transfer]; }
  const SourceState& source(std::uint32_t source) const noexcept { return sources_[source]; }
  /// The part that a transfer from `from` would move, or that would be taken by hand.
  Candidate candidate(const tables::PartLocation& from) const noexcept;
  /// The number of the first part that leaves no room for the one that a transfer would move; 0: there is room.
  std::uint64_t obstacle(const tables::TransferRow& row, const Candidate& found) const noexcept;

 private:
  /// A part between two locations.
  struct Moving {
    std::uint64_t number;
    std::uint32_t kind;
    std::uint32_t from;   ///< kNone: it was just made
    std::uint32_t index;  ///< among the parts of `from`
    bool by_hand;
  };
  struct Pass;

  tables::Time now() const noexcept;
  bool truth(std::uint32_t condition) const noexcept;
  bool holds(std::uint32_t condition) const noexcept { return condition == tables::kNone || truth(condition); }
  Position length(std::uint32_t kind) const noexcept { return index_.lengths[kind]; }
  void due_now() noexcept { due_ = true; }

  // Parts on tracks (flow_memory.cpp).
  Part& part(std::uint32_t track, std::uint32_t index) const noexcept {
    return parts_[index_.tracks[track].first_part + index];
  }
  Part& insert(std::uint32_t track, Position x) noexcept;
  void erase(std::uint32_t track, std::uint32_t index) noexcept;
  std::uint32_t front_most_covering(std::uint32_t track, Position at) const noexcept;
  std::uint32_t obstacle_on(std::uint32_t track, Position x, Position length, std::uint32_t except) const noexcept;
  void locate(std::uint32_t track, Part& part) noexcept;
  void cover(std::uint32_t track, Part& part) noexcept;
  void cover_changed(std::uint32_t track, std::uint32_t begin, std::uint32_t end) noexcept;

  // Motion (flow_moves.cpp).
  void track_due(std::uint32_t track) noexcept;
  void count_instant(std::uint32_t track) noexcept;
  void put_overshot(std::uint32_t track) noexcept;
  void freeze(std::uint32_t track) noexcept;
  void speed_changed(std::uint32_t position) noexcept;
  Position speed_of_drive(std::uint32_t drive) const noexcept;
  Position drive_speed(std::uint32_t track, const Part& part, Position x) const noexcept;
  bool stop_holds_at(std::uint32_t track, Position at) const noexcept {
    return index_.tracks[track].stop_count != 0 && a_stop_holds_at(track, at);
  }
  bool a_stop_holds_at(std::uint32_t track, Position at) const noexcept;
  void compute_speeds(std::uint32_t track) noexcept;
  void set_stale_dues(std::uint32_t track) noexcept;
  void all_speeds(std::uint32_t track) noexcept {
    tracks_[track].stale = 1;
    due_speeds_.mark(track);
  }
  void find_drive(std::uint32_t track, Part& part, Position x) const noexcept;

  // Parts that lie across two tracks (flow_tails.cpp).
  const Part* across(std::uint32_t track, std::uint32_t behind) const noexcept;
  /// Calls `function(track, part)` for each part whose tail is on the track `behind`. O(ends).
  template <class Function>
  void for_tails(std::uint32_t behind, Function function) const noexcept;
  bool has_tail(std::uint32_t track, const Part& part) const noexcept {
    return tracks_[track].tail_on != 0 && &part == &this->part(track, tracks_[track].size - 1);
  }
  void begin_tail(std::uint32_t track, std::uint32_t behind) noexcept;
  void end_tail(std::uint32_t track) noexcept;
  void follow_tail(std::uint32_t track) noexcept;
  void sensors_under_tail(std::uint32_t track) noexcept;
  tables::Time time_to_tail_mark(std::uint32_t track, const Part& part) const noexcept;
  tables::Time overtaking_due(std::uint32_t behind) const noexcept;
  tables::Time tail_room_due(std::uint32_t behind, Position end) const noexcept;
  void tails_due(std::uint32_t behind) noexcept;
  const Part* tail_in_the_way(std::uint32_t behind, Position x, const Moving& moving) const noexcept;
  const Part* tail_seen(const tables::SensorRow& sensor) const noexcept;

  // Due times (flow_times.cpp).
  void set_mark_due(std::uint32_t track, Part& part) const noexcept;
  void set_speed_due(std::uint32_t track, std::uint32_t index) const noexcept;
  void aim_forward(std::uint32_t track, Part& part, Position x) const noexcept;
  void aim_backward(std::uint32_t track, Part& part, Position x) const noexcept;
  void set_room_due(std::uint32_t track) noexcept;
  void set_track_wheel(std::uint32_t track) noexcept;
  void set_wheel(std::uint32_t entry, tables::Time due) noexcept;

  // Moves between locations (flow_moves.cpp), work and sources (flow_round.cpp).
  void try_end(std::uint32_t track) noexcept;
  bool try_transfer(std::uint32_t transfer) noexcept;
  bool try_work(std::uint32_t work) noexcept;
  void try_source(std::uint32_t source) noexcept;
  Position arrival(const tables::PartLocation& to, std::uint32_t kind) const noexcept;
  bool has_room(const tables::PartLocation& to, Position x, const Moving& moving) const noexcept;
  void move(const Moving& moving, const tables::PartLocation& to, Position x) noexcept;
  void leave(const Moving& moving) noexcept;
  void arrive(const Moving& moving, const tables::PartLocation& to, Position x) noexcept;
  void work_on(std::uint32_t location, std::uint32_t index, const tables::WorkRow& row) noexcept;
  void content_changed(std::uint32_t location) noexcept;
  void room_may_appear(std::uint32_t location) noexcept;
  void count_part(std::uint32_t location, std::uint32_t kind, std::int32_t change) noexcept;
  void note(const PartChange& change) noexcept;
  PlacePart& place_part(std::uint32_t place, std::uint32_t index) const noexcept;
  std::uint32_t next_kind(std::uint32_t source) const noexcept;
  void set_next_due(std::uint32_t source) noexcept;
  void settle(std::uint32_t location) noexcept;
  void settle_track(std::uint32_t track) noexcept;

  // Sensors (flow_round.cpp).
  void set_sensor(std::uint32_t sensor) noexcept;
  std::uint64_t reading(std::uint32_t sensor) const noexcept;
  bool is_blocked(std::uint32_t transfer) const noexcept;
  void hash_track(tables::Fnv1a64& hash, std::uint32_t track) const noexcept;
  bool sees(const tables::SensorRow& sensor, std::uint32_t kind) const noexcept;

  Engine& engine_;
  const tables::MaterialTables* material_ = nullptr;
  FlowIndex index_;
  bool active_ = false;

  // --- in the flat block
  TrackState* tracks_ = nullptr;
  Part* parts_ = nullptr;
  PlaceState* places_ = nullptr;
  PlacePart* place_parts_ = nullptr;
  TransferState* transfers_ = nullptr;
  WorkState* work_ = nullptr;
  SourceState* sources_ = nullptr;
  KindState* kinds_ = nullptr;
  std::uint64_t* counts_ = nullptr;  ///< of the counters
  std::uint64_t* next_number_ = nullptr;
  std::uint32_t first_entry_ = 0;  ///< in the wheel: of the tracks, then of the sources

  // --- outside of it
  RoundMarks due_ends_;  ///< tracks
  RoundMarks due_transfers_;
  RoundMarks due_work_;
  RoundMarks due_sources_;
  DirtySet due_speeds_;  ///< tracks
  DirtySet due_rooms_;   ///< tracks
  DirtySet due_sensors_;
  DirtySet due_counters_;
  DirtySet due_weights_;  ///< locations
  DirtySet moved_tracks_;
  DirtySet seen_transfers_;     ///< those that may have begun or ceased to be blocked in this instant
  Position* speeds_ = nullptr;  ///< of the parts of one track, while they are computed
  List<PartChange> changes_{};
  std::uint32_t most_changes_ = 0;
  const std::uint64_t* source_names_ = nullptr;  ///< fnv1a64 of each source's name in upper case
  std::uint32_t freezing_ = 0;  ///< the number of tracks that are frozen before the rounds of this instant
  bool due_ = false;
};

template <class Function>
void Flow::for_frozen_now(std::uint32_t first, Function function) const noexcept {
  const auto track_count = static_cast<std::uint32_t>(material_->tracks.size());
  const auto transfer_count = static_cast<std::uint32_t>(material_->transfers.size());
  for (std::uint32_t t = 0; t < track_count; ++t) {
    if (tracks_[t].frozen == kFrozenInThisInstant) function(first + t, tracks_[t].loop);
  }
  for (std::uint32_t t = 0; t < transfer_count; ++t) {
    if (transfers_[t].frozen == kFrozenInThisInstant) function(first + track_count + t, transfers_[t].steps);
  }
  for (std::uint32_t w = 0; w < material_->work.size(); ++w) {
    if (work_[w].frozen == kFrozenInThisInstant) function(first + track_count + transfer_count + w, work_[w].steps);
  }
}

template <class Function>
void Flow::for_tails(std::uint32_t behind, Function function) const noexcept {
  const tables::Rows rows = material_->tracks[behind].ends;
  const auto ends = material_->ends.subspan(rows.first, rows.count);
  for (auto end = ends.begin(); end != ends.end(); ++end) {
    const Part* const part = material_->is_track(end->to) ? across(end->to, behind) : nullptr;
    const auto leads_there = [&](const tables::EndRow& other) { return other.to == end->to; };
    if (part != nullptr && std::none_of(ends.begin(), end, leads_there)) function(end->to, *part);
  }
}

}  // namespace symplant::engine
