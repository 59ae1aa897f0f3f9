// Material flow in the reference (docs/material.md): what the instant and its rounds do with parts.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "support/reference/round.hpp"

namespace symplant::reference {

/// A location that a part would go to.
struct PartTarget {
  tables::PartLocation to;
  bool by_end = false;       ///< by the end of a track
  std::uint32_t kind = 0;    ///< of the part
  std::uint64_t number = 0;  ///< of the part; 0: it is not in the plant so far
};

inline std::int64_t units_of(std::int64_t micrometers) { return micrometers * kMicrometer; }
std::int64_t length_of(const Rules& rules, const PartWorld& part);
/// Its middle minus its front is half of this, negative: lengths are even in 10^-15 m.
std::int64_t middle_of(const Rules& rules, const PartWorld& part, Time time);
bool covers(const Rules& rules, const PartWorld& part, Time time, std::int64_t position);
bool sees(const model::PartSensor& sensor, const PartWorld& part);

MaterialWorld first_material(const Rules& rules);
/// Symbols of sensors, of tracks, then of places.
bool senses_parts(const model::PlantModel& model, std::uint32_t symbol);

// Rooms and moves from one location to another (material_room.cpp).
/// The front of a part that arrives at a track.
std::int64_t front_at_target(const Rules& rules, const PartTarget& target);
bool has_room_between_parts(const Rules& rules, const World& world, const PartTarget& target, Time time);
bool has_room(const Rules& rules, const World& world, const PartTarget& target, Time time);
/// The index of the part that a transfer takes from there.
std::optional<std::size_t> part_to_take(const Rules& rules, const World& world, const tables::PartLocation& from);
void arrive(const Rules& rules, World& world, PartWorld part, const PartTarget& target,
            std::vector<engine::PartChange>& changes, engine::PartChange change);
void make_part(const Rules& rules, World& world, const tables::PartLocation& to, std::uint32_t kind, bool by_hand,
               std::vector<engine::PartChange>& changes);
/// Moves a part to its target, which may be tables::kOut.
void move_part(const Rules& rules, World& world, std::uint32_t from, std::size_t index, const PartTarget& target,
               bool by_hand, std::vector<engine::PartChange>& changes);
std::uint64_t parts_at(const MaterialWorld& world, std::uint32_t location, std::uint32_t kind);

// Tails (material_tails.cpp).
/// The part of a tail while it lies across; nullptr: it does so no longer.
const PartWorld* across(const Rules& rules, const MaterialWorld& world, const TailWorld& tail, Time time);
/// What it covers of the track that it left begins here, and ends with that track.
std::int64_t begin_of_tail(const Rules& rules, const TailWorld& tail, const PartWorld& part, Time time);
/// The parts that a track's sensor reads before those of the track, in this order.
std::vector<const PartWorld*> tails_over(const Rules& rules, const MaterialWorld& world, std::uint32_t track,
                                         std::int64_t position, Time time);
bool has_room_between_tails(const Rules& rules, const World& world, const PartTarget& target, Time time);
/// The next time at which a tail gets further than another one on the same track.
Time order_due(const Rules& rules, const World& world);
/// Forgets the tails that have ended.
void drop_tails(const Rules& rules, World& world, Counters& counters);

// Movement (material_move.cpp). `conditions`: the snapshot.
std::int64_t drive_speed(const Rules& rules, const World& conditions, std::uint32_t track, const PartWorld& part);
bool stop_holds_at(const Rules& rules, const World& conditions, std::uint32_t track, std::int64_t position);
std::int64_t contact_with(const Rules& rules, const TrackWorld& track, const model::Track& its, std::size_t ahead,
                          Time time);
void set_speeds(Round& round);
/// Puts parts of a track that overshot a position exactly there.
void put_overshot(const Rules& rules, World& world, std::uint32_t track, Counters& counters);
/// Before the rounds of an instant: overshot parts, frozen tracks.
void begin_instant_of_parts(const Rules& rules, World& world, Counters& counters, InstantNotes& notes);

// A round (material_round.cpp).
/// The part that is at the end of a track and may leave it: where it goes. Empty without one.
std::optional<PartTarget> leaving(const Rules& rules, const World& conditions, const World& world, std::uint32_t track);
bool due_and_allowed(const Rules& rules, const World& conditions, const World& world, std::uint32_t source);
PartTarget next_of_source(const Rules& rules, const World& world, std::uint32_t source);
/// True if something happened that requires another round.
bool run_material(Round& round, int number);

// Times and what is true at the end of an instant (material_times.cpp).
void end_instant_of_parts(const Rules& rules, World& world, Counters& counters);
Time next_due_of_parts(const MaterialWorld& world);
/// Whether `part blocked` is true.
bool is_blocked(const Rules& rules, const World& world, std::uint32_t transfer);

/// What can be in an instantaneous loop has an index: units, symbols that follow, tracks, transfers, work, sources,
/// malfunctions of the description, values.
struct Steppers {
  std::size_t tracks;
  std::size_t transfers;
  std::size_t work;
  std::size_t sources;
  std::size_t malfunctions;
  std::size_t values;
  std::size_t end;
};
Steppers steppers(const Rules& rules);

}  // namespace symplant::reference
