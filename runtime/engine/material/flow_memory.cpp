// The memory and the look-ups of the material flow, and the parts of a track.
#include <algorithm>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/material/flow.hpp"
#include "symplant/engine/material/flow_index.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::engine {
namespace {

std::uint32_t size_of(auto rows) noexcept { return static_cast<std::uint32_t>(rows.size()); }

}  // namespace

void Flow::build(Arena& arena) noexcept {
  material_ = &engine_.tables_.material;
  active_ = !material_->empty();
  index_.build(engine_.tables_, arena);
  auto* const names = arena.take<std::uint64_t>(material_->sources.size());
  source_names_ = names;
  if (names == nullptr) return;
  std::string_view rest = material_->source_names;
  for (std::size_t s = 0; s < material_->sources.size() && !rest.empty(); ++s) {
    const std::size_t end = std::min(rest.find('\0'), rest.size() - 1);
    names[s] = upper_case_hash(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
}

void Flow::place(Arena& arena) noexcept {
  due_ends_.take(arena, material_->tracks.size());
  due_transfers_.take(arena, material_->transfers.size());
  due_work_.take(arena, material_->work.size());
  due_sources_.take(arena, material_->sources.size());
  due_speeds_.take(arena, material_->tracks.size());
  moved_tracks_.take(arena, material_->tracks.size());
  due_rooms_.take(arena, material_->tracks.size());
  due_sensors_.take(arena, material_->sensors.size());
  due_counters_.take(arena, material_->counters.size());
  due_weights_.take(arena, material_->locations());
  seen_transfers_.take(arena, material_->transfers.size());
  speeds_ = arena.take<Position>(active_ ? tables::kMaxPartsOnTrack : 0);
  most_changes_ = active_ ? kMostByHand + 4 * (size_of(material_->tracks) + size_of(material_->transfers)) +
                                index_.parts_on_tracks + index_.parts_in_places
                          : 0;
  changes_.take(arena, most_changes_);
  due_ = false;
}

void Flow::place_block(Arena& arena, std::uint32_t first_entry) noexcept {
  first_entry_ = first_entry;
  tracks_ = arena.take<TrackState>(material_->tracks.size());
  parts_ = arena.take<Part>(index_.parts_on_tracks);
  places_ = arena.take<PlaceState>(material_->places.size());
  place_parts_ = arena.take<PlacePart>(index_.parts_in_places);
  sources_ = arena.take<SourceState>(material_->sources.size());
  kinds_ = arena.take<KindState>(material_->kinds.size());
  counts_ = arena.take<std::uint64_t>(material_->counters.size());
  next_number_ = arena.take<std::uint64_t>(active_ ? 1 : 0);
  transfers_ = arena.take<TransferState>(material_->transfers.size());
  work_ = arena.take<WorkState>(material_->work.size());
  arena.take<std::uint64_t>(active_ ? 1 : 0);  // what follows is aligned
}

std::uint32_t Flow::wheel_entries() const noexcept { return size_of(material_->tracks) + size_of(material_->sources); }

/// The block is zero.
void Flow::reset() noexcept {
  if (!active_) return;
  for (std::uint32_t t = 0; t < material_->tracks.size(); ++t) {
    tracks_[t].room_due = tables::kNever;
    tracks_[t].window_begin = -tables::kSecond;  // the first instant begins one
  }
  for (std::uint32_t s = 0; s < material_->sources.size(); ++s) {
    const tables::SourceRow& row = material_->sources[s];
    sources_[s].due = row.count == 0 ? tables::kNever : row.first;
    if (sources_[s].due > 0) set_wheel(first_entry_ + size_of(material_->tracks) + s, sources_[s].due);
  }
  forget_changes();
}

void Flow::mark_all() noexcept {
  if (!active_) return;
  due_ends_.mark_all();
  due_transfers_.mark_all();
  due_work_.mark_all();
  due_sources_.mark_all();
  for (std::uint32_t t = 0; t < material_->tracks.size(); ++t) all_speeds(t);
  for (std::uint32_t s = 0; s < material_->sensors.size(); ++s) due_sensors_.mark(s);
  for (std::uint32_t c = 0; c < material_->counters.size(); ++c) due_counters_.mark(c);
  for (std::uint32_t l = 0; engine_.values_.active() && l < material_->locations(); ++l) {
    if (engine_.values_.reads_weight(l)) due_weights_.mark(l);
  }
  due_ = true;
}

namespace {

/// The track of each row, where `rows_of` gives a track's rows.
template <class RowsOf>
const std::uint32_t* tracks_of_rows(const tables::MaterialTables& material, std::size_t size, Arena& arena,
                                    RowsOf rows_of) noexcept {
  auto* const owners = arena.take<std::uint32_t>(size);
  if (owners == nullptr) return nullptr;
  for (std::uint32_t track = 0; track < material.tracks.size(); ++track) {
    const tables::Rows rows = rows_of(material.tracks[track]);
    std::fill_n(owners + rows.first, rows.count, track);
  }
  return owners;
}

/// Adds a track's marks at `end`, sorted; returns the new end.
Mark* add_marks(const tables::MaterialTables& material, std::uint32_t track,
                std::span<const std::uint32_t> transfers_from, Mark* end) noexcept {
  Mark* const begin = end;
  const tables::Rows sensors = material.tracks[track].sensors;
  for (std::uint32_t s = sensors.first; s < sensors.first + sensors.count; ++s) {
    *end++ = {material.sensors[s].at * kMicrometer, s, false};
  }
  for (const std::uint32_t t : transfers_from) {
    const std::int64_t at = material.transfers[t].from.at;
    *end++ = {(at == tables::kWhole ? material.tracks[track].length : at) * kMicrometer, t, true};
  }
  std::sort(begin, end, [](const Mark& a, const Mark& b) { return a.at < b.at; });
  return end;
}

void fill_stops(const tables::MaterialTables& material, std::uint32_t track, tables::StopRow* stops) noexcept {
  const tables::Rows rows = material.tracks[track].stops;
  for (std::uint32_t s = 0; s < rows.count; ++s) stops[s] = material.stops[rows.first + s];
  std::sort(stops, stops + rows.count, [](const tables::StopRow& a, const tables::StopRow& b) { return a.at < b.at; });
}

}  // namespace

void FlowIndex::build_tracks(const tables::PlantTables& tables, Arena& arena) noexcept {
  const tables::MaterialTables& material = tables.material;
  auto* const rows = arena.take<TrackIndex>(material.tracks.size());
  auto* mark = arena.take<Mark>(material.sensors.size() + material.transfers.size());
  auto* stop = arena.take<tables::StopRow>(material.stops.size());
  tracks = rows;
  for (std::uint32_t track = 0; track < material.tracks.size(); ++track) {
    const tables::TrackRow& row = material.tracks[track];
    const std::uint32_t capacity = tables::most_parts(material, row);
    if (rows != nullptr) {
      Mark* const end = add_marks(material, track, transfers_from.of(track), mark);
      fill_stops(material, track, stop);
      rows[track] = {
          row.length * kMicrometer, row.gap * kMicrometer, mark,    static_cast<std::uint32_t>(end - mark), stop,
          row.stops.count,          parts_on_tracks,       capacity};
      mark = end;
      stop += row.stops.count;
    }
    parts_on_tracks += capacity;
  }
}

void FlowIndex::build_arrivals(const tables::MaterialTables& material, Arena& arena) noexcept {
  const std::size_t locations = material.locations();
  ends_to.build(locations, arena, [&](auto add) {
    for (std::uint32_t track = 0; track < material.tracks.size(); ++track) {
      const tables::Rows rows = material.tracks[track].ends;
      for (std::uint32_t e = rows.first; e < rows.first + rows.count; ++e) {
        if (material.ends[e].to != tables::kOut) add(material.ends[e].to, track);
      }
    }
  });
  transfers_to.build(locations, arena, [&](auto add) {
    for (std::uint32_t t = 0; t < material.transfers.size(); ++t) {
      if (material.transfers[t].to.location != tables::kOut) add(material.transfers[t].to.location, t);
    }
  });
  transfers_from.build(locations, arena, [&](auto add) {
    for (std::uint32_t t = 0; t < material.transfers.size(); ++t) add(material.transfers[t].from.location, t);
  });
  sources_to.build(locations, arena, [&](auto add) {
    for (std::uint32_t s = 0; s < material.sources.size(); ++s) add(material.sources[s].to.location, s);
  });
  counters_of.build(locations, arena, [&](auto add) {
    for (std::uint32_t c = 0; c < material.counters.size(); ++c) add(material.counters[c].location, c);
  });
}

void FlowIndex::build_speed_readers(const tables::PlantTables& tables, Arena& arena) noexcept {
  const tables::MaterialTables& material = tables.material;
  std::uint32_t size = 0;
  for (const tables::DriveRow& drive : material.drives) size += drive.varies() ? 1U : 0U;
  auto* const readers = arena.take<SpeedReader>(size);
  if (readers == nullptr) return;
  SpeedReader* end = readers;
  for (std::uint32_t d = 0; d < material.drives.size(); ++d) {
    if (!material.drives[d].varies()) continue;
    if (material.drives[d].symbol == tables::kNone) {
      *end++ = {kOutputOfValue + material.drives[d].output, track_of_drive[d]};
      continue;
    }
    const tables::SymbolRow& symbol = tables.symbols[material.drives[d].symbol];
    const std::uint32_t plane = symbol.direction() == tables::Direction::event ? kEventSlot : 0;
    *end++ = {plane + symbol.index, track_of_drive[d]};
  }
  std::sort(readers, end, [](const SpeedReader& a, const SpeedReader& b) { return a.position < b.position; });
  speed_readers = {readers, end};
}

void FlowIndex::build(const tables::PlantTables& tables, Arena& arena) noexcept {
  const tables::MaterialTables& material = tables.material;
  if (material.empty()) return;
  build_arrivals(material, arena);
  build_tracks(tables, arena);
  auto* const kind_lengths = arena.take<Position>(material.kinds.size());
  lengths = kind_lengths;
  for (std::size_t k = 0; kind_lengths != nullptr && k < material.kinds.size(); ++k) {
    kind_lengths[k] = material.kinds[k].length * kMicrometer;
  }
  track_of_drive =
      tracks_of_rows(material, material.drives.size(), arena, [](const tables::TrackRow& row) { return row.drives; });
  track_of_stop =
      tracks_of_rows(material, material.stops.size(), arena, [](const tables::TrackRow& row) { return row.stops; });
  track_of_end =
      tracks_of_rows(material, material.ends.size(), arena, [](const tables::TrackRow& row) { return row.ends; });
  build_speed_readers(tables, arena);
  auto* const first = arena.take<std::uint32_t>(material.places.size());
  first_in_place = first;
  for (std::size_t p = 0; p < material.places.size(); ++p) {
    if (first != nullptr) first[p] = parts_in_places;
    parts_in_places += material.places[p].holds;
  }
}

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
  if (has_tail(track, part)) follow_tail(track);
}

/// The coverage of the marks from `begin` to before `end` may have changed.
void Flow::cover_changed(std::uint32_t track, std::uint32_t begin, std::uint32_t end) noexcept {
  for (std::uint32_t m = begin; m < end; ++m) {
    const Mark& mark = index_.tracks[track].marks[m];
    mark.transfer ? due_transfers_.mark(mark.of) : static_cast<void>(due_sensors_.mark(mark.of));
    due_now();
  }
}

double Flow::weight(std::uint32_t location) const noexcept {
  double sum = 0;
  const std::uint32_t count = parts(location);
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool on_track = material_->is_track(location);
    sum += material_->kinds[on_track ? part(location, i).kind : part_in(material_->place_of(location), i).kind].weight;
  }
  return sum;
}

}  // namespace symplant::engine
