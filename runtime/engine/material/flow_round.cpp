// The rounds of the material flow: what looks at what, work, sources, loops and blocked transfers.
#include <algorithm>
#include <bit>

#include "symplant/engine/draw.hpp"
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
    case tables::ReaderKind::change:
    case tables::ReaderKind::formula_input:
      return;
  }
}

void Flow::value_changed(tables::Direction direction, std::uint32_t slot) noexcept {
  speed_changed(slot + (direction == tables::Direction::event ? kEventSlot : 0));
}

void Flow::output_changed(std::uint32_t output) noexcept { speed_changed(kOutputOfValue + output); }

/// What gives the speed of drives has another number.
void Flow::speed_changed(std::uint32_t position) noexcept {
  auto reader = std::lower_bound(index_.speed_readers.begin(), index_.speed_readers.end(), position,
                                 [](const SpeedReader& a, std::uint32_t b) { return a.position < b; });
  for (; reader != index_.speed_readers.end() && reader->position == position; ++reader) {
    drives_changed(reader->track);
  }
}

void Flow::drives_changed(std::uint32_t track) noexcept {
  all_speeds(track);
  due_ends_.mark(track);
  due_now();
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
    if (tracks_[track].tail_on != 0) due_rooms_.mark(tracks_[track].tail_on - 1);
  });
  due_rooms_.take_all([&](std::uint32_t track) {
    set_room_due(track);
    set_track_wheel(track);
  });
  due_sensors_.take_all([&](std::uint32_t sensor) { set_sensor(sensor); });
  due_ = !(due_ends_.empty() && due_transfers_.empty() && due_work_.empty() && due_sources_.empty());
}

void Flow::publish_counters() noexcept {
  due_counters_.take_all([&](std::uint32_t counter) {
    engine_.compare_value(engine_.tables_.part_watches, counter, counts_[counter]);
    if (engine_.values_.active()) engine_.values_.counter_changed(counter, counts_[counter]);
  });
  due_weights_.take_all([&](std::uint32_t location) { engine_.values_.weight_changed(location); });
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
  if (const Part* const tail = tail_seen(row)) return value(tail->number, tail->kind);
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

void Flow::work_on(std::uint32_t location, std::uint32_t index, const tables::WorkRow& row) noexcept {
  std::uint64_t number = 0;
  if (material_->is_track(location)) {
    Part& p = part(location, index);
    cover(location, p);  // it may have passed marks that do not matter for its kind
    p.kind = row.to;
    p.stale = 1;
    number = p.number;
    cover_changed(location, p.tail, p.front);
    if (has_tail(location, p)) sensors_under_tail(location);
  } else {
    const std::uint32_t place = material_->place_of(location);
    PlacePart& p = place_part(place, index);
    p.kind = row.to;
    number = p.number;
  }
  count_part(location, row.from, -1);
  count_part(location, row.to, 1);
  note({number, row.to, tables::kNone, tables::kNone, 0, PartChange::What::changed, false});
  engine_.active_ = true;
}

/// True if a part changed.
bool Flow::try_work(std::uint32_t work) noexcept {
  const tables::WorkRow& row = material_->work[work];
  WorkState& state = work_[work];
  if (state.frozen != 0) return false;
  const bool on = holds(row.condition);
  const bool begins = on && state.began == 0;
  state.began = on ? 1 : 0;
  if (!begins) return false;
  bool any = false;
  const std::uint32_t location = row.at.location;
  for (std::uint32_t i = 0; i < parts(location); ++i) {
    if (material_->is_track(location)) {
      const Part& p = part(location, i);
      const Position x = p.at(now());
      const Position at = row.at.at * kMicrometer;
      const bool here = row.at.at == tables::kWhole || (x - length(p.kind) <= at && at <= x);
      if (!here || p.kind != row.from) continue;
    } else if (part_in(material_->place_of(location), i).kind != row.from) {
      continue;
    }
    work_on(location, i, row);
    any = true;
  }
  if (any) content_changed(location);
  return any;
}

std::uint32_t Flow::next_kind(std::uint32_t source) const noexcept {
  const tables::Rows kinds = material_->sources[source].kinds;
  return material_->source_kinds[kinds.first + static_cast<std::uint32_t>(sources_[source].made % kinds.count)];
}

void Flow::try_source(std::uint32_t source) noexcept {
  const tables::SourceRow& row = material_->sources[source];
  SourceState& state = sources_[source];
  state.waiting = 0;
  if (state.due > now() || !holds(row.condition)) return;
  const std::uint32_t kind = next_kind(source);
  const Moving moving{*next_number_ + 1, kind, tables::kNone, 0, false};
  const Position x = arrival(row.to, kind);
  if (!has_room(row.to, x, moving)) {
    state.waiting = 1;
    if (material_->is_track(row.to.location)) due_rooms_.mark(row.to.location);
    return;
  }
  ++*next_number_;
  move(moving, row.to, x);
  ++state.made;
  set_next_due(source);
}

void Flow::set_next_due(std::uint32_t source) noexcept {
  const tables::SourceRow& row = material_->sources[source];
  SourceState& state = sources_[source];
  if (state.made >= row.count || (row.every == 0 && row.count == tables::kAnyNumber)) {
    state.due = tables::kNever;
  } else if (row.every != 0) {
    tables::Time every = row.every;
    if (every < 0) {
      const std::uint64_t start = draw_start(engine_.head_->seed, source_names_[source], 0, state.draws++);
      every = random_time(engine_.tables_.random_times[static_cast<std::size_t>(-1 - every)], start);
    }
    state.due = later(now(), std::max<tables::Time>(1, every));
    set_wheel(first_entry_ + static_cast<std::uint32_t>(material_->tracks.size()) + source, state.due);
  } else {
    due_sources_.mark(source);
  }
}

/// Resets the step counts. A frozen transfer or work keeps the number of its loop there.
void Flow::forget_steps() noexcept {
  for (std::uint32_t t = 0; t < material_->transfers.size(); ++t) {
    if (transfers_[t].frozen == 0) transfers_[t].steps = 0;
  }
  for (std::uint32_t w = 0; w < material_->work.size(); ++w) {
    if (work_[w].frozen == 0) work_[w].steps = 0;
  }
}

bool Flow::has_loop() const noexcept {
  const auto acted_often = [](const auto& state) { return state.frozen == 0 && state.steps >= kLoopSteps; };
  return std::any_of(transfers_, transfers_ + material_->transfers.size(), acted_often) ||
         std::any_of(work_, work_ + material_->work.size(), acted_often);
}

void Flow::freeze_loop(std::uint8_t loop) noexcept {
  const auto look = [loop](auto& state) {
    if (state.frozen != 0 || state.steps < kLoopSteps) return;
    state.frozen = kFrozenInThisInstant;
    state.steps = loop;
  };
  std::for_each(transfers_, transfers_ + material_->transfers.size(), look);
  std::for_each(work_, work_ + material_->work.size(), look);
}

void Flow::close_loops() noexcept {
  const auto close = [](auto& state) {
    if (state.frozen != 0) state.frozen = kFrozenBefore;
  };
  for (std::uint32_t t = 0; t < material_->tracks.size(); ++t) close(tracks_[t]);
  for (std::uint32_t t = 0; t < material_->transfers.size(); ++t) close(transfers_[t]);
  for (std::uint32_t w = 0; w < material_->work.size(); ++w) close(work_[w]);
}

bool Flow::is_blocked(std::uint32_t transfer) const noexcept {
  const tables::TransferRow& row = material_->transfers[transfer];
  const TransferState& state = transfers_[transfer];
  if (row.condition == tables::kNone || state.frozen != 0 || state.moved != 0 || !truth(row.condition)) return false;
  const Candidate found = candidate(row.from);
  if (found.index == tables::kNone || row.to.location == tables::kOut) return false;
  return !has_room(row.to, arrival(row.to, found.kind), {0, found.kind, row.from.location, found.index, false});
}

void Flow::close_blocked(List<std::uint32_t>& begun) noexcept {
  seen_transfers_.take_all([&](std::uint32_t transfer) {
    const bool blocked = is_blocked(transfer);
    if (blocked && transfers_[transfer].blocked == 0) begun.add(transfer);
    transfers_[transfer].blocked = blocked ? 1 : 0;
  });
}

void Flow::hash_track(tables::Fnv1a64& hash, std::uint32_t track) const noexcept {
  hash.u32(tracks_[track].size);
  for (std::uint32_t i = 0; i < tracks_[track].size; ++i) {
    const Part& p = part(track, i);
    hash.u64(p.number);
    hash.u32(p.kind);
    hash.u64(static_cast<std::uint64_t>(p.x0));
    hash.time(p.t0);
    hash.time(p.v);
  }
  const TrackState& state = tracks_[track];
  const Part* const tail = state.tail_on != 0 ? across(track, state.tail_on - 1) : nullptr;
  hash.byte(static_cast<std::uint8_t>((state.frozen != 0 ? 1 : 0) | (tail != nullptr ? 2 : 0)));
  if (tail == nullptr) return;
  hash.u32(state.tail_on - 1);
  hash.time(tail->since);
}

void Flow::hash(tables::Fnv1a64& hash) const noexcept {
  if (!active_) return;
  for (std::uint32_t t = 0; t < material_->tracks.size(); ++t) hash_track(hash, t);
  for (std::uint32_t p = 0; p < material_->places.size(); ++p) {
    hash.u32(places_[p].size);
    for (std::uint32_t i = 0; i < places_[p].size; ++i) {
      hash.u64(part_in(p, i).number);
      hash.u32(part_in(p, i).kind);
    }
  }
  for (std::uint32_t t = 0; t < material_->transfers.size(); ++t) {
    const TransferState& state = transfers_[t];
    hash.byte(static_cast<std::uint8_t>(state.permission | state.moved << 1 | (state.frozen != 0 ? 4 : 0)));
  }
  for (std::uint32_t w = 0; w < material_->work.size(); ++w) {
    hash.byte(static_cast<std::uint8_t>(work_[w].began | (work_[w].frozen != 0 ? 2 : 0)));
  }
  for (std::uint32_t s = 0; s < material_->sources.size(); ++s) {
    hash.time(sources_[s].due);
    hash.u64(sources_[s].made);
    hash.u32(sources_[s].draws);
    hash.byte(0);  // a source is never frozen
  }
  hash.u64(*next_number_ + 1);
}

void Flow::hash_blocked(tables::Fnv1a64& hash) const noexcept {
  for (std::uint32_t t = 0; t < material_->transfers.size(); ++t) {
    if (transfers_[t].blocked == 0) continue;
    hash.byte(3);
    hash.u32(t);
  }
}

}  // namespace symplant::engine
