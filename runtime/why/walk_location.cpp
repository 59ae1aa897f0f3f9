// Why a track or place has its parts or none, and why sensors see them or not.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "symplant/why/walk.hpp"

namespace symplant::why {
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

}  // namespace symplant::why
