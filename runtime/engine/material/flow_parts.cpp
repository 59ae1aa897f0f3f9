// The parts of a track, from the front-most one to the last, without overlaps.
#include <algorithm>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/material/flow.hpp"

namespace symplant::engine {

/// Makes room for a part whose front is at x, behind those ahead of it. O(parts behind it).
Part& Flow::insert(std::uint32_t track, Position x) noexcept {
  TrackState& state = tracks_[track];
  Part* const parts = &part(track, 0);
  std::uint32_t index = state.size;
  while (index > 0 && parts[index - 1].at(now()) < x) --index;
  if (index < state.size) parts[index].stale = 1;
  std::copy_backward(parts + index, parts + state.size, parts + state.size + 1);
  ++state.size;
  return parts[index];
}

/// O(parts behind it).
void Flow::erase(std::uint32_t track, std::uint32_t index) noexcept {
  TrackState& state = tracks_[track];
  Part* const parts = &part(track, 0);
  std::copy(parts + index + 1, parts + state.size, parts + index);
  --state.size;
  if (index < state.size) parts[index].stale = 1;
}

/// The index of the front-most part that covers a position, or kNone. O(log parts).
std::uint32_t Flow::front_most_covering(std::uint32_t track, Position at) const noexcept {
  const tables::Time time = now();
  std::uint32_t begin = 0;
  std::uint32_t end = tracks_[track].size;
  while (begin < end) {  // the first part whose tail is not ahead of the position
    const std::uint32_t middle = begin + (end - begin) / 2;
    const Part& p = part(track, middle);
    if (p.at(time) - length(p.kind) > at) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin < tracks_[track].size && part(track, begin).at(time) >= at ? begin : tables::kNone;
}

/// The last part that leaves no room for a part of a length whose front is at x, without the one at index `except`.
std::uint32_t Flow::obstacle_on(std::uint32_t track, Position x, Position part_length,
                                std::uint32_t except) const noexcept {
  const tables::Time time = now();
  const Position gap = index_.tracks[track].gap;
  for (std::uint32_t i = tracks_[track].size; i-- > 0;) {
    if (i == except) continue;
    const Part& other = part(track, i);
    const Position front = other.at(time);
    if (front <= x - part_length - gap) continue;
    return front - length(other.kind) < x + gap ? i : tables::kNone;
  }
  return tables::kNone;
}

/// Finds the marks that a part covers, and its drive.
void Flow::locate(std::uint32_t track, Part& part) noexcept {
  const TrackIndex& row = index_.tracks[track];
  const Position x = part.at(now());
  const Mark* const end = row.marks + row.mark_count;
  const auto before = [](const Mark& mark, Position at) { return mark.at < at; };
  part.front = static_cast<std::uint32_t>(std::lower_bound(row.marks, end, x + 1, before) - row.marks);
  part.tail = static_cast<std::uint32_t>(std::lower_bound(row.marks, end, x - length(part.kind), before) - row.marks);
  part.drive = 0;
  find_drive(track, part, x);
  cover_changed(track, part.tail, part.front);
}

/// Updates the marks that a part covers after it moved. O(marks that it passed).
void Flow::cover(std::uint32_t track, Part& part) noexcept {
  const TrackIndex& row = index_.tracks[track];
  const Position x = part.at(now());
  const Position tail = x - length(part.kind);
  const std::uint32_t front_before = part.front;
  const std::uint32_t tail_before = part.tail;
  while (part.front < row.mark_count && row.marks[part.front].at <= x) ++part.front;
  while (part.front > 0 && row.marks[part.front - 1].at > x) --part.front;
  while (part.tail < row.mark_count && row.marks[part.tail].at < tail) ++part.tail;
  while (part.tail > 0 && row.marks[part.tail - 1].at >= tail) --part.tail;
  cover_changed(track, std::min(front_before, part.front), std::max(front_before, part.front));
  cover_changed(track, std::min(tail_before, part.tail), std::max(tail_before, part.tail));
}

/// The coverage of the marks from `begin` to before `end` may have changed.
void Flow::cover_changed(std::uint32_t track, std::uint32_t begin, std::uint32_t end) noexcept {
  for (std::uint32_t m = begin; m < end; ++m) {
    const Mark& mark = index_.tracks[track].marks[m];
    mark.transfer ? due_transfers_.mark(mark.of) : static_cast<void>(due_sensors_.mark(mark.of));
    due_now();
  }
}

}  // namespace symplant::engine
