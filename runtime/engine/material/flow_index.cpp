// Builds the look-ups of the material flow.
#include "symplant/engine/material/flow_index.hpp"

#include <algorithm>

namespace symplant::engine {
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
  for (const tables::DriveRow& drive : material.drives) size += drive.symbol != tables::kNone ? 1U : 0U;
  auto* const readers = arena.take<SpeedReader>(size);
  if (readers == nullptr) return;
  SpeedReader* end = readers;
  for (std::uint32_t d = 0; d < material.drives.size(); ++d) {
    if (material.drives[d].symbol == tables::kNone) continue;
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

}  // namespace symplant::engine
