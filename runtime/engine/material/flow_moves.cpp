// Moves of parts between locations: ends, transfers, and moves by hand.
#include <algorithm>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/material/flow.hpp"

namespace symplant::engine {

/// Where the front of a part is that arrives by anything but an end.
Position Flow::arrival(const tables::PartLocation& to, std::uint32_t kind) const noexcept {
  if (!material_->is_track(to.location)) return 0;
  if (to.at == tables::kWhole) return length(kind);
  return std::min(to.at * kMicrometer + length(kind) / 2, index_.tracks[to.location].length);
}

bool Flow::has_room(const tables::PartLocation& to, Position x, const Moving& moving) const noexcept {
  if (to.location == tables::kOut) return true;
  const bool stays = moving.from == to.location;
  if (!material_->is_track(to.location)) {
    const std::uint32_t place = material_->place_of(to.location);
    return places_[place].size - (stays ? 1U : 0U) < material_->places[place].holds;
  }
  const std::uint32_t except = stays ? moving.index : tables::kNone;
  if (tracks_[to.location].size - (stays ? 1U : 0U) >= index_.tracks[to.location].capacity) return false;
  return obstacle_on(to.location, x, length(moving.kind), except) == tables::kNone;
}

Candidate Flow::candidate(const tables::PartLocation& from) const noexcept {
  if (!material_->is_track(from.location)) {
    const std::uint32_t place = material_->place_of(from.location);
    if (places_[place].size == 0) return {};
    return {0, part_in(place, 0).kind};
  }
  const std::uint32_t track = from.location;
  std::uint32_t index = tables::kNone;
  if (from.at != tables::kWhole) {
    index = front_most_covering(track, from.at * kMicrometer);
  } else if (tracks_[track].size != 0 && part(track, 0).at(now()) >= index_.tracks[track].length) {
    index = 0;
  }
  if (index == tables::kNone) return {};
  return {index, part(track, index).kind};
}

std::uint32_t Flow::obstacle(const tables::PartLocation& to, std::uint32_t kind) const noexcept {
  if (to.location == tables::kOut) return tables::kNone;
  if (material_->is_track(to.location)) {
    return obstacle_on(to.location, arrival(to, kind), length(kind), tables::kNone);
  }
  const std::uint32_t place = material_->place_of(to.location);
  return places_[place].size < material_->places[place].holds ? tables::kNone : 0;
}

/// A part may have been taken away: what waits for room there looks again.
void Flow::room_may_appear(std::uint32_t location) noexcept {
  for (const std::uint32_t track : index_.ends_to.of(location)) {
    if (tracks_[track].waiting != 0) due_ends_.mark(track);
  }
  for (const std::uint32_t t : index_.transfers_to.of(location)) {
    if (transfers_[t].waiting != 0) due_transfers_.mark(t);
  }
  for (const std::uint32_t s : index_.sources_to.of(location)) {
    if (sources_[s].waiting != 0) due_sources_.mark(s);
  }
  due_now();
}

/// Parts came, left, or changed their kind.
void Flow::content_changed(std::uint32_t location) noexcept {
  due_now();
  for (const std::uint32_t t : index_.transfers_from.of(location)) due_transfers_.mark(t);
  if (material_->is_track(location)) {
    due_speeds_.mark(location);
    due_ends_.mark(location);
    moved_tracks_.mark(location);
    return;
  }
  const tables::Rows sensors = material_->places[material_->place_of(location)].sensors;
  for (std::uint32_t s = sensors.first; s < sensors.first + sensors.count; ++s) due_sensors_.mark(s);
}

void Flow::count_part(std::uint32_t location, std::uint32_t kind, std::int32_t change) noexcept {
  for (const std::uint32_t c : index_.counters_of.of(location)) {
    const std::uint32_t counted = material_->counters[c].kind;
    if (counted != tables::kNone && counted != kind) continue;
    counts_[c] += static_cast<std::uint64_t>(static_cast<std::int64_t>(change));
    due_counters_.mark(c);
    engine_.unpublished_ = true;
  }
}

/// Changes by hand between two instants beyond the list's capacity are not noted.
void Flow::note(const PartChange& change) noexcept {
  const bool in_instant = engine_.round_ != 0;
  if (in_instant && engine_.observer_ == nullptr) return;
  if (changes_.size == most_changes_) {
    if (!in_instant) return;
    engine_.observer_->parts_before(now(), changes_.view());
    changes_.size = 0;
  }
  changes_.add(change);
}

void Flow::leave(const Moving& moving) noexcept {
  if (material_->is_track(moving.from)) {
    const Part& p = part(moving.from, moving.index);
    cover_changed(moving.from, p.tail, p.front);
    erase(moving.from, moving.index);
  } else {
    PlaceState& place = places_[material_->place_of(moving.from)];
    place.begin = place.begin + 1 == material_->places[material_->place_of(moving.from)].holds ? 0 : place.begin + 1;
    --place.size;
  }
  count_part(moving.from, moving.kind, -1);
  content_changed(moving.from);
  room_may_appear(moving.from);
}

void Flow::arrive(const Moving& moving, const tables::PartLocation& to, Position x) noexcept {
  if (material_->is_track(to.location)) {
    Part& p = insert(to.location, x);
    p = {x, now(), 0, tables::kNever, tables::kNever, moving.number, now(), 0, moving.kind, 0, 0, 0, 1};
    locate(to.location, p);
  } else {
    const std::uint32_t place = material_->place_of(to.location);
    PlaceState& state = places_[place];
    const std::uint32_t holds = material_->places[place].holds;
    const std::uint32_t position =
        state.begin + state.size < holds ? state.begin + state.size : state.begin + state.size - holds;
    place_parts_[index_.first_in_place[place] + position] = {moving.number, now(), moving.kind, 0};
    ++state.size;
  }
  count_part(to.location, moving.kind, 1);
  content_changed(to.location);
}

/// Moves a part, which has room.
void Flow::move(const Moving& moving, const tables::PartLocation& to, Position x) noexcept {
  const bool made = moving.from == tables::kNone;
  const bool on_track = to.location != tables::kOut && material_->is_track(to.location);
  note({moving.number, moving.kind, moving.from, to.location, on_track ? x / kMicrometer : 0,
        made ? PartChange::What::made : PartChange::What::moved, moving.by_hand});
  if (made) {
    ++kinds_[moving.kind].made;
  } else {
    leave(moving);
  }
  if (to.location == tables::kOut) {
    ++kinds_[moving.kind].gone;
  } else {
    arrive(moving, to, x);
  }
  engine_.active_ = true;
}

void Flow::try_end(std::uint32_t track) noexcept {
  TrackState& state = tracks_[track];
  state.waiting = 0;
  if (state.frozen != 0 || state.size == 0) return;
  const Part& p = part(track, 0);
  const Position x = p.at(now());
  const Position end = index_.tracks[track].length;
  if (x < end || drive_speed(track, p, x) <= 0 || stop_holds_at(track, end)) return;
  const tables::Rows ends = material_->tracks[track].ends;
  for (std::uint32_t e = ends.first; e < ends.first + ends.count; ++e) {
    const tables::EndRow& row = material_->ends[e];
    if (!holds(row.condition)) continue;
    const Moving moving{p.number, p.kind, track, 0, false};
    if (has_room({row.to, tables::kWhole}, 0, moving)) {
      move(moving, {row.to, tables::kWhole}, 0);
      return;
    }
    state.waiting = 1;
    state.waiting_kind = p.kind;
    if (material_->is_track(row.to)) due_rooms_.mark(row.to);
    return;
  }
}

/// True if it moved a part.
bool Flow::try_transfer(std::uint32_t transfer) noexcept {
  const tables::TransferRow& row = material_->transfers[transfer];
  TransferState& state = transfers_[transfer];
  if (state.frozen != 0) return false;
  seen_transfers_.mark(transfer);
  state.waiting = 0;
  const bool on = holds(row.condition);
  if (on && state.began == 0) {
    state.permission = 1;
    state.moved = 0;
  }
  state.began = on ? 1 : 0;
  if (!on || (row.once && state.permission == 0)) return false;
  const Candidate found = candidate(row.from);
  if (found.index == tables::kNone) return false;
  const bool from_track = material_->is_track(row.from.location);
  const std::uint64_t number = from_track ? part(row.from.location, found.index).number
                                          : part_in(material_->place_of(row.from.location), 0).number;
  const Moving moving{number, found.kind, row.from.location, found.index, false};
  const Position x = row.to.location == tables::kOut ? 0 : arrival(row.to, found.kind);
  if (!has_room(row.to, x, moving)) {
    state.waiting = 1;
    state.waiting_kind = found.kind;
    if (material_->is_track(row.to.location)) due_rooms_.mark(row.to.location);
    return false;
  }
  move(moving, row.to, x);
  state.permission = 0;
  state.moved = 1;
  due_transfers_.mark(transfer);
  return true;
}

bool Flow::put(const tables::PartLocation& to, std::uint32_t kind) noexcept {
  if (to.location >= material_->locations() || kind >= material_->kinds.size()) return false;
  settle(to.location);
  const Moving moving{*next_number_ + 1, kind, tables::kNone, 0, true};
  const Position x = arrival(to, kind);
  if (!has_room(to, x, moving)) return false;
  ++*next_number_;
  move(moving, to, x);
  return true;
}

bool Flow::take(const tables::PartLocation& from) noexcept {
  if (from.location >= material_->locations()) return false;
  settle(from.location);
  const Candidate found = candidate(from);
  if (found.index == tables::kNone) return false;
  const std::uint64_t number = material_->is_track(from.location)
                                   ? part(from.location, found.index).number
                                   : part_in(material_->place_of(from.location), 0).number;
  move({number, found.kind, from.location, found.index, true}, {tables::kOut, tables::kWhole}, 0);
  return true;
}

/// Before parts are put or taken by hand: those of a track that have just reached their position are put there.
void Flow::settle(std::uint32_t location) noexcept {
  if (!material_->is_track(location)) return;
  for (std::uint32_t i = 0; i < tracks_[location].size; ++i) {
    if (part(location, i).speed_due > now()) continue;
    put_overshot(location);
    return;
  }
}

}  // namespace symplant::engine
