// The material flow's part of a round, and what makes a round look at something.
#include <algorithm>
#include <bit>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/material/flow.hpp"

namespace symplant::engine {

void Flow::entry_due(std::uint32_t entry) noexcept {
  const auto track_count = static_cast<std::uint32_t>(material_->tracks.size());
  if (entry < track_count) {
    track_due(entry);
    return;
  }
  due_sources_.mark(entry - track_count);
  due_now();
}

void Flow::condition_changed(tables::ReaderKind kind, std::uint32_t reader) noexcept {
  due_now();
  switch (kind) {
    case tables::ReaderKind::drive:
      all_speeds(index_.track_of_drive[reader]);
      due_ends_.mark(index_.track_of_drive[reader]);
      return;
    case tables::ReaderKind::stop:
      all_speeds(index_.track_of_stop[reader]);
      due_ends_.mark(index_.track_of_stop[reader]);
      return;
    case tables::ReaderKind::end:
      due_ends_.mark(index_.track_of_end[reader]);
      return;
    case tables::ReaderKind::transfer:
      due_transfers_.mark(reader);
      return;
    case tables::ReaderKind::work:
      due_work_.mark(reader);
      return;
    case tables::ReaderKind::source:
      due_sources_.mark(reader);
      return;
    case tables::ReaderKind::unit:
    case tables::ReaderKind::condition:
    case tables::ReaderKind::requirement:
    case tables::ReaderKind::follow:
    case tables::ReaderKind::malfunction:
      return;
  }
}

void Flow::value_changed(tables::Direction direction, std::uint32_t slot) noexcept {
  const std::uint32_t position = slot + (direction == tables::Direction::event ? kEventSlot : 0);
  auto reader = std::lower_bound(index_.speed_readers.begin(), index_.speed_readers.end(), position,
                                 [](const SpeedReader& a, std::uint32_t b) { return a.position < b; });
  for (; reader != index_.speed_readers.end() && reader->position == position; ++reader) {
    all_speeds(reader->track);
    due_ends_.mark(reader->track);
    due_now();
  }
}

/// Ends, transfers, work and sources in this order; then speeds and sensors (docs/material.md, "One instant").
void Flow::round(bool counting) noexcept {
  const auto count = [counting](std::uint8_t& steps) {
    if (counting && steps < kLoopSteps) ++steps;
  };
  due_ends_.visit([&](std::uint32_t track) { try_end(track); });
  due_transfers_.visit([&](std::uint32_t t) {
    if (try_transfer(t)) count(transfers_[t].steps);
  });
  due_work_.visit([&](std::uint32_t w) {
    if (try_work(w)) count(work_[w].steps);
  });
  due_sources_.visit([&](std::uint32_t s) { try_source(s); });
  due_speeds_.take_all([&](std::uint32_t track) {
    compute_speeds(track);
    due_rooms_.mark(track);
  });
  due_rooms_.take_all([&](std::uint32_t track) {
    set_room_due(track);
    set_track_wheel(track);
  });
  due_sensors_.take_all([&](std::uint32_t sensor) { set_sensor(sensor); });
  due_ = !(due_ends_.empty() && due_transfers_.empty() && due_work_.empty() && due_sources_.empty());
}

void Flow::publish_counters() noexcept {
  due_counters_.take_all(
      [&](std::uint32_t counter) { engine_.compare_value(engine_.tables_.part_watches, counter, counts_[counter]); });
}

bool Flow::sees(const tables::SensorRow& sensor, std::uint32_t kind) const noexcept {
  if (sensor.kinds.count == 0) return true;
  const auto kinds = material_->sensor_kinds.subspan(sensor.kinds.first, sensor.kinds.count);
  return std::binary_search(kinds.begin(), kinds.end(), kind);
}

/// The front-most part that a sensor sees, as its symbol's value; 0 without one.
std::uint64_t Flow::reading(std::uint32_t sensor) const noexcept {
  const tables::SensorRow& row = material_->sensors[sensor];
  const auto value = [&](std::uint64_t number, std::uint32_t kind) -> std::uint64_t {
    if (row.reads == tables::SensorReads::part) return 1;
    return row.reads == tables::SensorReads::number ? number : material_->kinds[kind].code;
  };
  if (!material_->is_track(row.location)) {
    const std::uint32_t place = material_->place_of(row.location);
    for (std::uint32_t i = 0; i < places_[place].size; ++i) {
      const PlacePart& p = part_in(place, i);
      if (sees(row, p.kind)) return value(p.number, p.kind);
    }
    return 0;
  }
  const Position at = row.at * kMicrometer;
  for (std::uint32_t i = front_most_covering(row.location, at); i < tracks_[row.location].size; ++i) {
    const Part& p = part(row.location, i);
    if (p.at(now()) < at) return 0;
    if (sees(row, p.kind)) return value(p.number, p.kind);
  }
  return 0;
}

void Flow::set_sensor(std::uint32_t sensor) noexcept {
  const tables::SymbolRow& symbol = engine_.tables_.symbols[material_->sensors[sensor].symbol];
  const std::uint64_t now_reads = reading(sensor);
  if (symbol.type() == tables::DataType::boolean) {
    const std::uint64_t mask = bit_in_word(symbol.index);
    const std::uint32_t word = symbol.index / 64;
    if ((now_reads != 0) == ((engine_.events_.made(word) & mask) != 0)) return;
    engine_.make_event_bits(word, now_reads != 0 ? mask : 0, now_reads != 0 ? 0 : mask);
  } else {
    const bool real = symbol.type() == tables::DataType::real || symbol.type() == tables::DataType::lreal;
    const std::uint64_t value = real ? std::bit_cast<std::uint64_t>(static_cast<double>(now_reads)) : now_reads;
    if (engine_.event_values_.made[symbol.index] == value) return;
    engine_.make_event_value(symbol.index, value);
  }
  engine_.active_ = true;
}

std::uint32_t Flow::parts(std::uint32_t location) const noexcept {
  return material_->is_track(location) ? tracks_[location].size : places_[material_->place_of(location)].size;
}

PlacePart& Flow::place_part(std::uint32_t place, std::uint32_t index) const noexcept {
  std::uint32_t position = places_[place].begin + index;
  if (position >= material_->places[place].holds) position -= material_->places[place].holds;
  return place_parts_[index_.first_in_place[place] + position];
}

const PlacePart& Flow::part_in(std::uint32_t place, std::uint32_t index) const noexcept {
  return place_part(place, index);
}

}  // namespace symplant::engine
