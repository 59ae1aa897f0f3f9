// Parts that move along their tracks and between locations.
#include <algorithm>
#include <bit>
#include <cmath>

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
  return obstacle_on(to.location, x, length(moving.kind), except) == tables::kNone &&
         tail_in_the_way(to.location, x, moving) == nullptr;
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

std::uint64_t Flow::obstacle(const tables::TransferRow& row, const Candidate& found) const noexcept {
  if (row.to.location == tables::kOut) return 0;
  if (!material_->is_track(row.to.location)) {
    const std::uint32_t place = material_->place_of(row.to.location);
    return places_[place].size < material_->places[place].holds ? 0 : part_in(place, 0).number;
  }
  const Position x = arrival(row.to, found.kind);
  const std::uint32_t index = obstacle_on(row.to.location, x, length(found.kind), tables::kNone);
  if (index != tables::kNone) return part(row.to.location, index).number;
  const Part* const tail = tail_in_the_way(row.to.location, x, {0, found.kind, row.from.location, found.index, false});
  return tail != nullptr ? tail->number : 0;
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
  if (engine_.values_.active() && engine_.values_.reads_weight(location)) {
    due_weights_.mark(location);
    engine_.unpublished_ = true;
  }
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
    if (has_tail(moving.from, p)) end_tail(moving.from);
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
    if (has_tail(to.location, p)) end_tail(to.location);  // it is over if a part arrives behind it
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
      if (material_->is_track(row.to)) begin_tail(row.to, track);
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
  settle_track(location);
  for_tails(location, [&](std::uint32_t track, const Part&) { settle_track(track); });
}

void Flow::settle_track(std::uint32_t track) noexcept {
  for (std::uint32_t i = 0; i < tracks_[track].size; ++i) {
    if (part(track, i).speed_due > now()) continue;
    put_overshot(track);
    return;
  }
}

namespace {

double number_of(tables::DataType type, std::uint64_t value) noexcept {
  if (type == tables::DataType::real || type == tables::DataType::lreal) return std::bit_cast<double>(value);
  const bool is_signed = type >= tables::DataType::sint && type <= tables::DataType::lint;
  return is_signed ? static_cast<double>(static_cast<std::int64_t>(value)) : static_cast<double>(value);
}

}  // namespace

Position Flow::speed_of_drive(std::uint32_t drive) const noexcept {
  const tables::DriveRow& row = material_->drives[drive];
  const bool forward = row.always_forward() || (row.forward != tables::kNone && truth(row.forward));
  const bool backward = row.backward != tables::kNone && truth(row.backward);
  if (forward == backward) return 0;
  Position speed = row.speed;
  if (row.varies()) {
    const double number = row.symbol == tables::kNone
                              ? engine_.values_.output(row.output)
                              : number_of(engine_.tables_.symbols[row.symbol].type(), engine_.symbol_value(row.symbol));
    const double given = number * static_cast<double>(row.speed);
    constexpr auto kMost = static_cast<double>(tables::kMaxSpeed);
    speed = std::isnan(given) ? 0 : static_cast<Position>(std::clamp(given, -kMost, kMost));
  }
  return engine_.malfunctions_.slowed_drive(index_.track_of_drive[drive], forward ? speed : -speed);
}

/// The speed of the drive that has the part's middle; 0 between two drives that face each other.
Position Flow::drive_speed(std::uint32_t track, const Part& part, Position x) const noexcept {
  const std::uint32_t drive = material_->tracks[track].drives.first + part.drive;
  const Position speed = speed_of_drive(drive);
  if (speed >= 0 || part.drive == 0) return speed;
  const Position boundary = material_->drives[drive - 1].until * kMicrometer;
  return x - length(part.kind) / 2 == boundary && speed_of_drive(drive - 1) > 0 ? 0 : speed;
}

bool Flow::a_stop_holds_at(std::uint32_t track, Position at) const noexcept {
  const auto stops = index_.tracks[track].sorted_stops();
  auto stop = std::lower_bound(stops.begin(), stops.end(), at, [](const tables::StopRow& row, Position position) {
    return row.at * kMicrometer < position;
  });
  for (; stop != stops.end() && stop->at * kMicrometer == at; ++stop) {
    if (truth(stop->condition)) return true;
  }
  return false;
}

/// Before the actions and rounds of an instant: a part of the track has reached something.
void Flow::track_due(std::uint32_t track) noexcept {
  TrackState& state = tracks_[track];
  const tables::Time time = now();
  tables::Time next_mark = tables::kNever;
  tables::Time next_speed = tables::kNever;
  const Part* const end = &part(track, 0) + state.size;
  for (const Part* p = &part(track, 0); p != end; ++p) {
    next_mark = std::min(next_mark, p->mark_due);
    next_speed = std::min(next_speed, p->speed_due);
  }
  const bool speeds = next_speed <= time;
  if (speeds || next_mark <= time) count_instant(track);
  if (speeds) put_overshot(track);
  if (state.room_due <= time) {
    state.room_due = tables::kNever;
    room_may_appear(track);
    tails_due(track);
  }
  next_mark = tables::kNever;
  for (Part* p = &part(track, 0); p != end; ++p) {
    if (p->speed_due <= time) {
      find_drive(track, *p, p->at(time));
      p->stale = 1;
    }
    if (p->mark_due <= time || p->stale != 0) cover(track, *p);
    if (p->mark_due <= time) set_mark_due(track, *p);
    next_mark = std::min(next_mark, p->mark_due);
  }
  if (!speeds) {
    set_wheel(first_entry_ + track, std::min({state.room_due, next_mark, next_speed}));
    return;
  }
  due_speeds_.mark(track);
  due_ends_.mark(track);
  due_now();
}

void Flow::count_instant(std::uint32_t track) noexcept {
  TrackState& state = tracks_[track];
  if (state.instants > kMostInLoopWindow) {
    state.freezing = 1;
    ++freezing_;
    return;
  }
  if (now() - state.window_begin >= kLoopWindow) {
    state.window_begin = now();
    state.instants = 0;
  }
  ++state.instants;
}

/// Freezes the tracks that caused too many instants before this one, which they caused too.
void Flow::begin_rounds() noexcept {
  if (freezing_ == 0) return;
  freezing_ = 0;
  for (std::uint32_t t = 0; t < material_->tracks.size(); ++t) {
    if (tracks_[t].freezing != 0) freeze(t);
  }
}

/// Parts that have reached the position at which they must be exactly, in the last ns, are put there: those for which
/// this is due, and those that touch one that was put.
void Flow::put_overshot(std::uint32_t track) noexcept {
  const tables::Time time = now();
  const Position gap = index_.tracks[track].gap;
  const std::uint32_t size = tracks_[track].size;
  Part* const parts = &part(track, 0);
  bool put = false;
  for (std::uint32_t i = 0; i < size; ++i) {
    Part& p = parts[i];
    const bool look = put || p.speed_due <= time;
    put = false;
    if (p.v <= 0 || !look) continue;
    const Position x = p.at(time);
    Position to = std::min(x, p.aim);
    if (i > 0) to = std::min(to, parts[i - 1].at(time) - length(parts[i - 1].kind) - gap);
    to = std::max(to, p.x0);
    put = to != x;
    if (put) p.base(to, time);
  }
  put = false;
  for (std::uint32_t i = size; i-- > 0;) {
    Part& p = parts[i];
    const bool look = put || p.speed_due <= time || (i + 1 < size && parts[i + 1].speed_due <= time);
    put = false;
    if (p.v >= 0 || !look) continue;
    const Position x = p.at(time);
    Position to = std::max(x, p.aim);
    if (i + 1 < size) to = std::max(to, parts[i + 1].at(time) + gap + length(p.kind));
    to = std::min(to, p.x0);
    put = to != x;
    if (put) p.base(to, time);
  }
}

void Flow::freeze(std::uint32_t track) noexcept {
  TrackState& state = tracks_[track];
  state.freezing = 0;
  state.frozen = kFrozenInThisInstant;
  if (engine_.loops_ != 0xFF) ++engine_.loops_;
  state.loop = engine_.loops_;
  engine_.suspects_ |= suspect(tables::FindingKind::instantaneous_loop);
  due_speeds_.mark(track);
  due_now();
}

/// The speeds of all parts of a track, in two passes, and what follows from them. O(parts).
void Flow::compute_speeds(std::uint32_t track) noexcept {
  const TrackIndex& row = index_.tracks[track];
  const TrackState& state = tracks_[track];
  const tables::Time time = now();
  Position* const speeds = speeds_;
  Part* const parts = &part(track, 0);
  Position ahead_tail = kBeyond;
  std::uint32_t drive = tables::kNone;  // of the part ahead
  Position forward = 0;                 // its speed, if that is forward; else 0
  for (std::uint32_t i = 0; i < state.size; ++i) {
    const Part& p = parts[i];
    const Position x = p.at(time);
    Position w = forward;
    if (forward == 0 || p.drive != drive) {
      w = state.frozen != 0 ? 0 : drive_speed(track, p, x);
      drive = p.drive;
      forward = std::max<Position>(w, 0);
    }
    if (w > 0) {
      if (x >= row.length || stop_holds_at(track, x)) w = 0;
      if (i > 0 && x >= ahead_tail - row.gap) w = std::min(w, std::max<Position>(speeds[i - 1], 0));
    }
    speeds[i] = w;
    ahead_tail = x - length(p.kind);
  }
  for (std::uint32_t i = state.size; i-- > 0;) {
    Part& p = parts[i];
    Position w = speeds[i];
    if (w >= 0 && w == p.v) continue;
    const Position x = p.at(time);
    const Position tail = x - length(p.kind);
    if (w < 0) {
      if (tail <= 0 || stop_holds_at(track, tail)) w = 0;
      if (i + 1 < state.size && parts[i + 1].at(time) >= tail - row.gap) {
        w = std::max(w, std::min<Position>(speeds[i + 1], 0));
      }
    }
    speeds[i] = w;
    if (w == p.v) continue;
    p.base(x, time);
    p.v = static_cast<std::int32_t>(w);
    moved_tracks_.mark(track);
  }
  set_stale_dues(track);
}

/// Computes the due times of the parts for which they may have changed: those that are stale, and of the next one
/// behind when it touches them.
void Flow::set_stale_dues(std::uint32_t track) noexcept {
  TrackState& state = tracks_[track];
  Part* const parts = &part(track, 0);
  const bool all = state.stale != 0;
  state.stale = 0;
  bool ahead = false;
  for (std::uint32_t i = 0; i < state.size; ++i) {
    const bool stale = parts[i].stale != 0;
    if (stale) set_mark_due(track, parts[i]);
    if (all || stale || ahead) set_speed_due(track, i);
    parts[i].stale = 0;
    ahead = stale;
  }
}

/// Finds the drive whose range has the part's middle. O(drives that it passed).
void Flow::find_drive(std::uint32_t track, Part& part, Position x) const noexcept {
  const tables::Rows drives = material_->tracks[track].drives;
  const Position middle = x - length(part.kind) / 2;
  const auto until = [&](std::uint32_t drive) { return material_->drives[drives.first + drive].until * kMicrometer; };
  while (part.drive + 1 < drives.count && middle >= until(part.drive)) ++part.drive;
  while (part.drive > 0 && middle < until(part.drive - 1)) --part.drive;
}

}  // namespace symplant::engine
