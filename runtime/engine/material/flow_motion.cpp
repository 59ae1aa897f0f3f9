// The motion of the parts of a track: what happens at its due times, and the speeds of its parts.
#include <algorithm>
#include <bit>
#include <cmath>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/material/flow.hpp"

namespace symplant::engine {
namespace {

double number_of(tables::DataType type, std::uint64_t value) noexcept {
  if (type == tables::DataType::real || type == tables::DataType::lreal) return std::bit_cast<double>(value);
  const bool is_signed = type >= tables::DataType::sint && type <= tables::DataType::lint;
  return is_signed ? static_cast<double>(static_cast<std::int64_t>(value)) : static_cast<double>(value);
}

}  // namespace

Position Flow::speed_of_drive(std::uint32_t drive) const noexcept {
  const tables::DriveRow& row = material_->drives[drive];
  const bool forward = row.forward != tables::kNone && truth(row.forward);
  const bool backward = row.backward != tables::kNone && truth(row.backward);
  if (forward == backward) return 0;
  Position speed = row.speed;
  if (row.symbol != tables::kNone) {
    const double given = number_of(engine_.tables_.symbols[row.symbol].type(), engine_.symbol_value(row.symbol)) *
                         static_cast<double>(row.speed);
    constexpr auto kMost = static_cast<double>(tables::kMaxSpeed);
    speed = std::isnan(given) ? 0 : static_cast<Position>(std::clamp(given, -kMost, kMost));
  }
  return forward ? speed : -speed;
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
