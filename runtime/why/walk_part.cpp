// Why a part does not move, and what moves parts.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/influences.hpp"
#include "symplant/trace/value_text.hpp"
#include "symplant/why/walk.hpp"

namespace symplant::why {
namespace {

/// The speed that a number gives, in um/s, as the engine computes it. Only its sign matters here.
double speed_of(tables::DataType type, std::uint64_t value, std::int64_t unit) {
  const double number = trace::is_real(type)     ? std::bit_cast<double>(value)
                        : trace::is_signed(type) ? static_cast<double>(static_cast<std::int64_t>(value))
                                                 : static_cast<double>(value);
  const double speed = std::trunc(number * static_cast<double>(unit));
  return std::isnan(speed) ? 0 : speed;
}

}  // namespace

/// The direction in which a drive moves parts: -1, 0 or 1.
int Walk::direction_of_drive(std::uint32_t drive) const {
  const tables::DriveRow& row = tables_.material.drives[drive];
  const auto on = [&](std::uint32_t condition) {
    return condition != tables::kNone && holds(index_.conditions.network(condition), view_);
  };
  const bool forward = row.always_forward() || on(row.forward);
  if (forward == on(row.backward)) return 0;
  double speed = 1;
  if (row.symbol != tables::kNone) {
    speed = speed_of(tables_.symbols[row.symbol].type(), view_.value(row.symbol), row.speed);
  }
  if (row.output != tables::kNone) speed = view_.output(row.output).value_or(0);
  const int direction = speed > 0 ? 1 : speed < 0 ? -1 : 0;
  return forward ? direction : -direction;
}

Explanation Walk::part(const Place& place) {
  const PartState& part = place.parts[place.index];
  const Reference self{Reference::Kind::part, static_cast<std::uint32_t>(part.number)};
  const std::string name = fmt::format("part {} ({})", part.number, names_.part_kind(part.kind));
  Explanation result{{}, {self, {Reference::Kind::location, place.track}}, {}};
  if (!part.x) {
    result.sentence =
        fmt::format("{} has been on {} {}", name, names_.location(place.track), trace::since_words(part.since));
    return result;
  }
  result.sentence =
      fmt::format("{} on {}, with its front at {}, ", name, names_.location(place.track), millimeters(*part.x));
  if (part.speed != 0) {
    result.sentence +=
        fmt::format("moves {}at {}/s", part.speed < 0 ? "backward " : "", millimeters(std::abs(part.speed)));
    const std::string slowed = trace::braking_malfunctions(place.track, names_, view_.malfunctions());
    if (!slowed.empty()) result.sentence += ", slowed by " + slowed;
    return result;
  }
  result.sentence += "does not move";
  if (is_mentioned(self, result)) return result;
  const Level level(*this, self);
  add_halt(place, result);
  append(result.because, causes(takers_of(place), [this](const Reference& taker) { return transfer(taker.index); }));
  return result;
}

/// What stops a part.
void Walk::add_halt(const Place& place, Explanation& result) {
  const tables::MaterialTables& material = tables_.material;
  const tables::TrackRow& track = material.tracks[place.track];
  const PartState& part = place.parts[place.index];
  const std::int64_t length = material.kinds[part.kind].length;
  if (view_.is_frozen_track(place.track).value_or(false)) {
    result.sentence += ": the track is in an instantaneous loop, and stays frozen until the run ends";
    return;
  }
  if (const std::string by = trace::stopping_malfunctions(place.track, names_, view_.malfunctions()); !by.empty()) {
    result.sentence += ": " + by + " stops its drives";
    return;
  }
  const std::uint32_t drive = track.drives.first + part.drive;
  const int direction = direction_of_drive(drive);
  if (direction == 0) {
    add_drive(drive, result);
    return;
  }
  if (direction < 0 && part.drive > 0 && direction_of_drive(drive - 1) > 0) {
    const std::int64_t middle = 2 * *part.x - length;  // twice as much, rounded down
    const std::int64_t boundary = 2 * material.drives[drive - 1].until;
    if (middle <= boundary && boundary < middle + 2) {
      result.sentence += ": two drives push it against each other";
      return;
    }
  }
  const std::int64_t edge = direction > 0 ? *part.x : *part.x - length;
  for (const tables::StopRow& stop : material.stops.subspan(track.stops.first, track.stops.count)) {
    const Network condition = index_.conditions.network(stop.condition);
    if (stop.at != edge || !holds(condition, view_)) continue;
    result.sentence += fmt::format(": the stop at {} holds", millimeters(stop.at));
    append(result.because, causes_of(changes_of(condition, view_)));
    return;
  }
  const bool ends = direction > 0 ? edge >= track.length : edge <= 0;
  if (ends && direction > 0) return add_end(place, result);
  if (ends) {
    result.sentence += ": it is at the start of the track";
    return;
  }
  const std::size_t other = direction > 0 ? place.index - 1 : place.index + 1;
  if (other >= place.parts.size()) {  // none is there: whole micrometers per second may be too many
    const std::string by = trace::braking_malfunctions(place.track, names_, view_.malfunctions());
    if (!by.empty()) result.sentence += ": " + by + " slows its drive to 0";
    return;
  }
  result.sentence += fmt::format(": part {} is in front of it", place.parts[other].number);
  append(result.because, causes(std::vector{other}, [&](std::size_t i) {
           return this->part({place.track, i, place.parts});
         }));
}

/// Why a drive does not move.
void Walk::add_drive(std::uint32_t drive, Explanation& result) {
  const tables::DriveRow& row = tables_.material.drives[drive];
  const auto network = [this](std::uint32_t condition) { return index_.conditions.network(condition); };
  const bool forward = row.forward != tables::kNone && holds(network(row.forward), view_);
  const bool backward = row.backward != tables::kNone && holds(network(row.backward), view_);
  if (forward && backward) {
    result.sentence += ": its drive is commanded forward and backward";
    append(result.because, causes_of(changes_of(network(row.forward), view_)));
    append(result.because, causes_of(changes_of(network(row.backward), view_)));
  } else if (forward || backward) {
    result.sentence += ": the speed of its drive is 0";
    append(result.because, causes(std::vector{row.symbol}, [this](std::uint32_t of) { return symbol(of); }));
  } else {
    result.sentence += ": its drive is off";
    if (row.forward != tables::kNone) add_need(result, ", `forward`", network(row.forward));
    if (row.backward != tables::kNone) add_need(result, ", `backward`", network(row.backward));
  }
}

/// Why a part at the end of a track stays there.
void Walk::add_end(const Place& place, Explanation& result) {
  const tables::TrackRow& track = tables_.material.tracks[place.track];
  result.sentence += ": the track ends there";
  for (const tables::EndRow& end : tables_.material.ends.subspan(track.ends.first, track.ends.count)) {
    const std::string to(names_.location(end.to));
    if (end.condition != tables::kNone &&
        add_need(result, fmt::format(", to {} `when`", to), index_.conditions.network(end.condition))) {
      continue;
    }
    if (end.to == tables::kOut) return;
    result.sentence += fmt::format(", {} has no room", to);
    append(result.because, causes(std::vector{end.to}, [this](std::uint32_t of) { return location(of); }));
    return;
  }
}

namespace {

template <class RowsWithLocation, class LocationOf>
void add_matching(const RowsWithLocation& rows, std::uint32_t location, Reference::Kind kind, LocationOf location_of,
                  std::vector<Reference>& found) {
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    if (location_of(rows[i]) == location) found.push_back({kind, i});
  }
}

}  // namespace

Explanation Walk::location(std::uint32_t location) {
  const Reference self{Reference::Kind::location, location};
  Explanation result{location_head(location), {self}, {}};
  if (is_mentioned(self, result)) return result;
  const Level level(*this, self);
  const auto explain = [this](const Reference& each) { return thing(each); };
  const std::vector<PartState> parts = view_.parts(location);
  if (parts.empty()) {
    const std::vector<Reference> feeders = feeders_of(location);
    if (feeders.empty()) result.sentence += ": nothing brings parts there";
    append(result.because, causes(feeders, explain));
    return result;
  }
  if (tables_.material.is_track(location)) {
    std::vector<std::size_t> indexes(parts.size());
    std::iota(indexes.begin(), indexes.end(), std::size_t{0});
    append(result.because, causes(indexes, [&](std::size_t i) { return part({location, i, parts}); }));
    return result;
  }
  const std::vector<Reference> takers = takers_of({location, 0, parts});
  if (takers.empty()) result.sentence += ": nothing takes parts from there";
  append(result.because, causes(takers, explain));
  return result;
}

/// What brings parts to a location: transfers, tracks that end there, sources.
std::vector<Reference> Walk::feeders_of(std::uint32_t location) const {
  const tables::MaterialTables& material = tables_.material;
  std::vector<Reference> feeders;
  add_matching(
      material.transfers, location, Reference::Kind::transfer,
      [](const tables::TransferRow& row) { return row.to.location; }, feeders);
  for (std::uint32_t t = 0; t < material.tracks.size(); ++t) {
    const tables::Rows rows = material.tracks[t].ends;
    const auto ends = material.ends.subspan(rows.first, rows.count);
    const bool leads =
        std::any_of(ends.begin(), ends.end(), [&](const tables::EndRow& end) { return end.to == location; });
    if (leads && t != location) feeders.push_back({Reference::Kind::location, t});
  }
  add_matching(
      material.sources, location, Reference::Kind::source, [](const tables::SourceRow& row) { return row.to.location; },
      feeders);
  return feeders;
}

/// The transfers that take a part from where it is.
std::vector<Reference> Walk::takers_of(const Place& place) const {
  const tables::MaterialTables& material = tables_.material;
  const PartState& part = place.parts[place.index];
  std::vector<Reference> takers;
  for (std::uint32_t t = 0; t < material.transfers.size(); ++t) {
    const tables::PartLocation& from = material.transfers[t].from;
    if (from.location != place.track) continue;
    if (material.is_track(place.track)) {
      if (!part.x) continue;
      const bool whole = from.at == tables::kWhole;
      const std::int64_t at = whole ? material.tracks[place.track].length : from.at;
      if (*part.x < at || *part.x - material.kinds[part.kind].length > at || (whole && place.index != 0)) continue;
    }
    takers.push_back({Reference::Kind::transfer, t});
  }
  return takers;
}

/// An event that a sensor of parts sets.
void Walk::add_sensor(std::uint32_t symbol, Explanation& result) {
  const tables::MaterialTables& material = tables_.material;
  const auto row = std::find_if(material.sensors.begin(), material.sensors.end(),
                                [symbol](const tables::SensorRow& sensor) { return sensor.symbol == symbol; });
  if (row == material.sensors.end()) return;
  const auto kinds = material.sensor_kinds.subspan(row->kinds.first, row->kinds.count);
  std::string seen = kinds.empty() ? "parts" : "parts of kind ";
  for (const std::uint32_t kind : kinds) {
    seen.append(kind == kinds.front() ? "" : " or ").append(names_.part_kind(kind));
  }
  const bool on_track = material.is_track(row->location);
  result.sentence +=
      fmt::format(": it sees {} at {}", seen, place_words({row->location, on_track ? row->at : tables::kWhole}));
  result.about.push_back({Reference::Kind::location, row->location});
  const std::vector<PartState> parts = view_.parts(row->location);
  if (!on_track || parts.empty() || !parts.front().x) {
    append(result.because, causes(std::vector{row->location}, [this](std::uint32_t of) { return location(of); }));
    return;
  }
  // From the front: the first part whose tail is not ahead of the sensor covers it, or is the next one to come.
  const auto next = std::find_if(parts.begin(), parts.end(), [&](const PartState& part) {
    return *part.x - material.kinds[part.kind].length <= row->at;
  });
  if (next == parts.end()) {
    result.sentence += fmt::format(", and part {} has passed it", parts.back().number);
    append(result.because,
           causes(feeders_of(row->location), [this](const Reference& feeder) { return thing(feeder); }));
    return;
  }
  const auto index = static_cast<std::size_t>(next - parts.begin());
  result.sentence += fmt::format(", and part {} {}", next->number, *next->x >= row->at ? "covers it" : "comes next");
  append(result.because, causes(std::vector{index}, [&](std::size_t i) { return part({row->location, i, parts}); }));
}

Explanation Walk::transfer(std::uint32_t transfer) {
  const tables::TransferRow& row = tables_.material.transfers[transfer];
  const Reference self{Reference::Kind::transfer, transfer};
  Explanation result{fmt::format("transfer `{}` moves no part from {} to {}", names_.transfer(transfer),
                                 place_words(row.from), place_words(row.to)),
                     {self},
                     {}};
  if (is_mentioned(self, result)) return result;
  const Level level(*this, self);
  const auto known = view_.transfer(transfer);
  if (known && known->frozen) {
    result.sentence += ": it is in an instantaneous loop, and stays frozen until the run ends";
    return result;
  }
  if (row.condition != tables::kNone && add_need(result, ": `when`", index_.conditions.network(row.condition))) {
    return result;
  }
  const bool is_empty = known ? known->part == 0 : view_.parts(row.from.location).empty();
  const auto explain = [this](std::uint32_t of) { return location(of); };
  if (known && known->spent) {
    result.sentence += ": it has moved one, and moves another one after `when` has begun to hold again";
  } else if (is_empty) {
    result.sentence += ": no part is there";
    append(result.because, causes(std::vector{row.from.location}, explain));
  } else if (known && known->obstacle != 0) {
    result.sentence += fmt::format(": part {} leaves no room", known->obstacle);
    append(result.because, causes(std::vector{row.to.location}, explain));
  }
  return result;
}

Explanation Walk::work(std::uint32_t work) {
  const tables::WorkRow& row = tables_.material.work[work];
  const Reference self{Reference::Kind::work, work};
  Explanation result{fmt::format("work `{}` makes {} of {} at {} when its `when` begins to hold", names_.work(work),
                                 names_.part_kind(row.to), names_.part_kind(row.from), place_words(row.at)),
                     {self},
                     {}};
  const Level level(*this, self);
  if (add_need(result, ": that", index_.conditions.network(row.condition))) return result;
  result.sentence += ": it holds already";
  append(result.because, causes(std::vector{row.at.location}, [this](std::uint32_t of) { return location(of); }));
  return result;
}

Explanation Walk::source(std::uint32_t source) {
  const tables::SourceRow& row = tables_.material.sources[source];
  const Reference self{Reference::Kind::source, source};
  Explanation result{
      fmt::format("source `{}` makes no part at {}", names_.source(source), place_words(row.to)), {self}, {}};
  if (is_mentioned(self, result)) return result;
  const Level level(*this, self);
  const auto known = view_.source(source);
  if (known && known->due == tables::kNever) {
    result.sentence += fmt::format(": it has made all of its parts, {}", known->made);
  } else if (row.condition != tables::kNone && add_need(result, ": `when`", index_.conditions.network(row.condition))) {
    return result;
  } else if (known && known->due > view_.now()) {
    result.sentence += fmt::format(": the next one is due at {}", trace::seconds(known->due));
  } else if (known) {
    result.sentence += ": there is no room";
    append(result.because, causes(std::vector{row.to.location}, [this](std::uint32_t of) { return location(of); }));
  }
  return result;
}

}  // namespace symplant::why
