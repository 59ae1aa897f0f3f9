// When the next instant of a track is due, with the speeds as they are (docs/material.md).
#include <algorithm>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/material/flow.hpp"

namespace symplant::engine {

/// When a part's front or tail passes the next mark that matters for its kind. O(marks of other kinds between).
void Flow::set_mark_due(std::uint32_t track, Part& p) const noexcept {
  p.mark_due = tables::kNever;
  if (p.v == 0) return;
  const TrackIndex& row = index_.tracks[track];
  const tables::Time time = now();
  const Position front = p.at(time);
  const Position tail = front - length(p.kind);
  const auto matters = [&](const Mark& mark) { return mark.transfer || sees(material_->sensors[mark.of], p.kind); };
  const auto due_in = [&](tables::Time left) { p.mark_due = std::min(p.mark_due, later(time, left)); };
  if (p.v > 0) {
    std::uint32_t next = p.front;
    while (next < row.mark_count && !matters(row.marks[next])) ++next;
    if (next < row.mark_count) due_in(time_to_reach(row.marks[next].at - front, p.v));
    next = p.tail;
    while (next < row.mark_count && !matters(row.marks[next])) ++next;
    if (next < row.mark_count) due_in(time_to_pass(row.marks[next].at - tail, p.v));
    if (has_tail(track, p)) due_in(time_to_tail_mark(track, p));
    return;
  }
  std::uint32_t next = p.front;
  while (next > 0 && !matters(row.marks[next - 1])) --next;
  if (next > 0) due_in(time_to_pass(front - row.marks[next - 1].at, -p.v));
  next = p.tail;
  while (next > 0 && !matters(row.marks[next - 1])) --next;
  if (next > 0) due_in(time_to_reach(tail - row.marks[next - 1].at, -p.v));
}

/// The track's end, a stop that holds, or a boundary to a drive that faces the part's own, whichever is next; and when
/// the part reaches it or the next drive.
void Flow::aim_forward(std::uint32_t track, Part& p, Position x) const noexcept {
  const TrackIndex& row = index_.tracks[track];
  const tables::Time time = now();
  p.aim = x < row.length ? row.length : kBeyond;
  const auto stops = row.sorted_stops();
  auto stop = std::upper_bound(stops.begin(), stops.end(), x, [](Position position, const tables::StopRow& it) {
    return position < it.at * kMicrometer;
  });
  while (stop != stops.end() && !truth(stop->condition)) ++stop;
  if (stop != stops.end()) p.aim = std::min(p.aim, stop->at * kMicrometer);
  const tables::Rows drives = material_->tracks[track].drives;
  if (p.drive + 1 < drives.count) {
    const std::uint32_t drive = drives.first + p.drive;
    const Position half = length(p.kind) / 2;
    const Position boundary = material_->drives[drive].until * kMicrometer;
    const bool facing = speed_of_drive(drive) > 0 && speed_of_drive(drive + 1) < 0;
    if (facing) p.aim = std::min(p.aim, boundary + half);
    p.speed_due = std::min(p.speed_due, later(time, time_to_reach(boundary - (x - half), p.v)));
  }
  if (p.aim != kBeyond) p.speed_due = std::min(p.speed_due, later(time, time_to_reach(p.aim - x, p.v)));
}

/// The same backward: the start of the track, a stop at the part's tail, a boundary.
void Flow::aim_backward(std::uint32_t track, Part& p, Position x) const noexcept {
  const tables::Time time = now();
  const Position part_length = length(p.kind);
  const Position tail = x - part_length;
  p.aim = tail > 0 ? part_length : -kBeyond;
  const auto stops = index_.tracks[track].sorted_stops();
  auto stop = std::lower_bound(stops.begin(), stops.end(), tail, [](const tables::StopRow& it, Position position) {
    return it.at * kMicrometer < position;
  });
  while (stop != stops.begin() && !truth((stop - 1)->condition)) --stop;
  if (stop != stops.begin()) p.aim = std::max(p.aim, (stop - 1)->at * kMicrometer + part_length);
  if (p.drive > 0) {
    const std::uint32_t drive = material_->tracks[track].drives.first + p.drive;
    const Position half = part_length / 2;
    const Position boundary = material_->drives[drive - 1].until * kMicrometer;
    const bool facing = speed_of_drive(drive - 1) > 0 && speed_of_drive(drive) < 0;
    if (facing && x - half > boundary) p.aim = std::max(p.aim, boundary + half);
    p.speed_due = std::min(p.speed_due, later(time, time_to_pass(x - half - boundary, -p.v)));
  }
  if (p.aim != -kBeyond) p.speed_due = std::min(p.speed_due, later(time, time_to_reach(x - p.aim, -p.v)));
}

/// When a part reaches something that may change a speed. A part that the one ahead reaches, moving backward, counts
/// as the one that touches.
void Flow::set_speed_due(std::uint32_t track, std::uint32_t index) const noexcept {
  Part& p = part(track, index);
  const tables::Time time = now();
  p.speed_due = tables::kNever;
  const Position x = p.at(time);
  if (p.v > 0) aim_forward(track, p, x);
  if (p.v < 0) aim_backward(track, p, x);
  if (index == 0) return;
  const Part& ahead = part(track, index - 1);
  const Position closing = Position{p.v} - ahead.v;
  const Position distance = ahead.at(time) - length(ahead.kind) - index_.tracks[track].gap - x;
  if (closing > 0 && distance > 0) p.speed_due = std::min(p.speed_due, later(time, time_to_reach(distance, closing)));
}

/// When the first of the parts leaves that take the room of one that waits for it.
void Flow::set_room_due(std::uint32_t track) noexcept {
  TrackState& state = tracks_[track];
  const tables::Time time = now();
  const Position gap = index_.tracks[track].gap;
  state.room_due = overtaking_due(track);
  const auto wait_for = [&](Position x, std::uint32_t kind) {
    const Position begin = x - length(kind) - gap;
    const Position end = x + gap;
    state.room_due = std::min(state.room_due, tail_room_due(track, end));
    for (std::uint32_t i = state.size; i-- > 0;) {
      const Part& p = part(track, i);
      const Position front = p.at(time);
      const Position tail = front - length(p.kind);
      if (tail >= end) return;
      if (front <= begin || p.v == 0) continue;
      const tables::Time left = p.v > 0 ? time_to_reach(end - tail, p.v) : time_to_reach(front - begin, -Position{p.v});
      state.room_due = std::min(state.room_due, later(time, left));
    }
  };
  for (const std::uint32_t from : index_.ends_to.of(track)) {
    if (tracks_[from].waiting != 0) wait_for(0, tracks_[from].waiting_kind);
  }
  for (const std::uint32_t t : index_.transfers_to.of(track)) {
    const std::uint32_t kind = transfers_[t].waiting_kind;
    if (transfers_[t].waiting != 0) wait_for(arrival(material_->transfers[t].to, kind), kind);
  }
  for (const std::uint32_t s : index_.sources_to.of(track)) {
    const std::uint32_t kind = next_kind(s);
    if (sources_[s].waiting != 0) wait_for(arrival(material_->sources[s].to, kind), kind);
  }
}

void Flow::set_track_wheel(std::uint32_t track) noexcept {
  const TrackState& state = tracks_[track];
  tables::Time due = state.room_due;
  for (std::uint32_t i = 0; i < state.size; ++i) {
    const Part& p = part(track, i);
    due = std::min(due, std::min(p.mark_due, p.speed_due));
  }
  set_wheel(first_entry_ + track, due);
}

void Flow::set_wheel(std::uint32_t entry, tables::Time due) noexcept {
  if ((engine_.units_[entry].flags & kTimed) != 0 && engine_.units_[entry].due == due) return;
  engine_.set_wheel(entry, due);
}

}  // namespace symplant::engine
