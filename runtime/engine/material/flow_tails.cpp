// Parts that lie across two tracks: what is still covered of the one that they came from (docs/material.md, "The end").
//
// Only the last part of a track can lie across its start: nothing arrives behind it before it has passed the start.
#include <algorithm>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/material/flow.hpp"

namespace symplant::engine {
namespace {

/// Whether one part is further than another on their tracks; of equal ones, whether it left first.
bool is_further(const Part& a, const Part& b, tables::Time time) noexcept {
  return a.at(time) != b.at(time) ? a.at(time) > b.at(time) : a.since < b.since;
}

}  // namespace

/// The last part of a track, if its tail is still on the track `behind`.
const Part* Flow::across(std::uint32_t track, std::uint32_t behind) const noexcept {
  const TrackState& state = tracks_[track];
  if (state.tail_on != behind + 1) return nullptr;
  const Part& p = part(track, state.size - 1);
  return p.at(now()) < length(p.kind) ? &p : nullptr;
}

/// The last part of a track has just come from the end of the track `behind`.
void Flow::begin_tail(std::uint32_t track, std::uint32_t behind) noexcept {
  TrackState& state = tracks_[track];
  const TrackIndex& row = index_.tracks[behind];
  const Position begin = row.length - length(part(track, state.size - 1).kind);
  const auto before = [](const Mark& mark, Position at) { return mark.at < at; };
  state.tail_on = behind + 1;
  state.tail_mark =
      static_cast<std::uint32_t>(std::lower_bound(row.marks, row.marks + row.mark_count, begin, before) - row.marks);
}

void Flow::end_tail(std::uint32_t track) noexcept {
  const std::uint32_t behind = tracks_[track].tail_on - 1;
  sensors_under_tail(track);
  tracks_[track].tail_on = 0;
  room_may_appear(behind);
}

void Flow::sensors_under_tail(std::uint32_t track) noexcept {
  const std::uint32_t behind = tracks_[track].tail_on - 1;
  cover_changed(behind, tracks_[track].tail_mark, index_.tracks[behind].mark_count);
}

/// Updates the marks under a tail after its part moved. A part is no longer across once its length has passed.
void Flow::follow_tail(std::uint32_t track) noexcept {
  TrackState& state = tracks_[track];
  const Part& p = part(track, state.size - 1);
  const std::uint32_t behind = state.tail_on - 1;
  const TrackIndex& row = index_.tracks[behind];
  const Position left = p.at(now()) - length(p.kind);
  const std::uint32_t before = state.tail_mark;
  while (state.tail_mark < row.mark_count && (left >= 0 || row.marks[state.tail_mark].at < row.length + left)) {
    ++state.tail_mark;
  }
  cover_changed(behind, before, state.tail_mark);
  if (left >= 0) state.tail_on = 0;
}

/// How long a tail, which moves, still covers the next sensor that sees its kind; kNever: it covers none.
tables::Time Flow::time_to_tail_mark(std::uint32_t track, const Part& p) const noexcept {
  const TrackIndex& row = index_.tracks[tracks_[track].tail_on - 1];
  const Position left = length(p.kind) - p.at(now());
  for (std::uint32_t m = tracks_[track].tail_mark; m < row.mark_count && left > 0; ++m) {
    const Mark& mark = row.marks[m];
    if (mark.transfer || !sees(material_->sensors[mark.of], p.kind)) continue;
    if (mark.at == row.length) return time_to_reach(left, p.v);
    return time_to_pass(mark.at - (row.length - left), p.v);
  }
  return tables::kNever;
}

/// When a tail gets further than another one of the same track.
tables::Time Flow::overtaking_due(std::uint32_t behind) const noexcept {
  const tables::Time time = now();
  tables::Time due = tables::kNever;
  for_tails(behind, [&](std::uint32_t, const Part& ahead) {
    for_tails(behind, [&](std::uint32_t, const Part& p) {
      const Position closing = Position{p.v} - ahead.v;
      if (closing <= 0 || !is_further(ahead, p, time)) return;
      const Position distance = ahead.at(time) - p.at(time);
      const bool first = p.since < ahead.since;
      due = std::min(due, later(time, first ? time_to_reach(distance, closing) : time_to_pass(distance, closing)));
    });
  });
  return due;
}

/// When the first tail leaves what is before `end` on the track `behind`.
tables::Time Flow::tail_room_due(std::uint32_t behind, Position end) const noexcept {
  const tables::Time time = now();
  const Position track_length = index_.tracks[behind].length;
  tables::Time due = tables::kNever;
  for_tails(behind, [&](std::uint32_t, const Part& p) {
    const Position left = std::min(end, track_length) - (track_length + p.at(time) - length(p.kind));
    if (left > 0 && p.v > 0) due = std::min(due, later(time, time_to_reach(left, p.v)));
  });
  return due;
}

/// The sensors of a track look at its tails again, whose order may have changed.
void Flow::tails_due(std::uint32_t behind) noexcept {
  for_tails(behind, [&](std::uint32_t track, const Part&) {
    sensors_under_tail(track);
    due_rooms_.mark(behind);
  });
}

/// A tail on the track `behind` that leaves no room for a front at x.
const Part* Flow::tail_in_the_way(std::uint32_t behind, Position x, const Moving& moving) const noexcept {
  const TrackIndex& row = index_.tracks[behind];
  const Part* found = nullptr;
  for_tails(behind, [&](std::uint32_t track, const Part& p) {
    if (moving.from == track && moving.index + 1 == tracks_[track].size) return;
    if (row.length + p.at(now()) - length(p.kind) < x + row.gap) found = &p;
  });
  return found;
}

/// The tail that a sensor of a track sees; nullptr: it sees none.
const Part* Flow::tail_seen(const tables::SensorRow& sensor) const noexcept {
  const tables::Time time = now();
  const Part* seen = nullptr;
  for_tails(sensor.location, [&](std::uint32_t, const Part& p) {
    const Position tail = index_.tracks[sensor.location].length + p.at(time) - length(p.kind);
    if (tail > sensor.at * kMicrometer || !sees(sensor, p.kind)) return;
    if (seen == nullptr || is_further(p, *seen, time)) seen = &p;
  });
  return seen;
}

}  // namespace symplant::engine
