// Resolves tracks and places.
#include "elements/material/tracks.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace symplant::model {
namespace {

using description::Pointer;
using description::ticked;

void check_range(const description::GivenTrack& given, std::size_t index, std::int64_t before, const Pointer& here,
                 description::Faults& faults) {
  const auto& until = given.drives[index].until;
  const bool last = index + 1 == given.drives.size();
  if (until.has_value() == last) {
    faults.add(last ? here / "until" : here,
               last ? "the last drive moves parts up to the end of the track; remove `until`"
                    : "only the last drive has no `until`; add the position up to which this one moves parts");
  } else if (until && *until > given.length && given.length != 0) {
    faults.add(here / "until", "this is beyond the end of the track; write a smaller `until`");
  } else if (until && *until <= before) {
    faults.add(here / "until",
               index == 0 ? "this drive moves no part; write an `until` above 0"
                          : "the drives are not in order; write an `until` above that of the drive before this one");
  }
}

void add_drives(const description::GivenTrack& given, const Pointer& here, MaterialLookup& lookup, Track& track) {
  std::int64_t before = 0;
  for (std::size_t i = 0; i < given.drives.size(); ++i) {
    const description::GivenDrive& drive = given.drives[i];
    check_range(given, i, before, here / i, lookup.faults());
    Drive made{drive.until.value_or(given.length),
               lookup.condition(drive.forward, here / i / "forward"),
               lookup.condition(drive.backward, here / i / "backward"),
               drive.speed.speed,
               kNone,
               kNone};
    if (!drive.speed.of.empty()) lookup.number(drive.speed.of, here / i / "speed" / "of", made);
    before = made.until;
    track.drives.push_back(std::move(made));
  }
}

std::vector<PartSensor> sensors(const std::vector<description::GivenSensor>& given, const Pointer& here,
                                MaterialLookup& lookup, const Track* track) {
  std::vector<PartSensor> sensors;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (track != nullptr) check_position(*track, given[i].at.value_or(0), here / i / "at", lookup.faults());
    PartSensor sensor{lookup.sensor_symbol(given[i].symbol), given[i].at.value_or(0), {}, given[i].reads};
    for (std::size_t k = 0; k < given[i].kinds.size(); ++k) {
      sensor.kinds.push_back(lookup.kind(given[i].kinds[k], here / i / "kinds" / k));
    }
    std::sort(sensor.kinds.begin(), sensor.kinds.end());
    sensor.kinds.erase(std::unique(sensor.kinds.begin(), sensor.kinds.end()), sensor.kinds.end());
    if (sensor.symbol != kNone) sensors.push_back(std::move(sensor));
  }
  return sensors;
}

void check_parts(const Track& track, const Pointer& here, MaterialLookup& lookup) {
  const Material& material = lookup.plant().material;
  for (const PartKind& kind : material.kinds) {
    if (kind.length <= track.length || track.length == 0) continue;
    lookup.faults().add(here / "length",
                        "kind " + ticked(kind.name) + " is longer than this track; make the track longer");
    return;
  }
  const std::uint64_t most = most_parts(material, track);
  if (most <= tables::kMaxPartsOnTrack) return;
  lookup.faults().add(here / "length", "up to " + std::to_string(most) + " parts fit on this track, more than " +
                                           std::to_string(tables::kMaxPartsOnTrack) +
                                           "; divide the track, or make the parts or the gap longer");
}

}  // namespace

void resolve_track(const description::GivenTrack& given, const MadeBy& by, MaterialLookup& lookup, Track& track) {
  const Pointer here = lookup.begin("tracks", by);
  track.gap = given.gap;
  track.given = by.given;
  add_drives(given, here / "drives", lookup, track);
  for (std::size_t i = 0; i < given.stops.size(); ++i) {
    Stop stop{given.stops[i].at, {}};
    check_position(track, stop.at, here / "stops" / i / "at", lookup.faults());
    lookup.condition(given.stops[i].when, here / "stops" / i / "when", stop.condition);
    track.stops.push_back(std::move(stop));
  }
  track.sensors = sensors(given.sensors, here / "sensors", lookup, &track);
  for (std::size_t i = 0; i < given.ends.size(); ++i) {
    const std::uint32_t to = lookup.end(given.ends[i].to, here / "end" / i / "to");
    track.ends.push_back({to, lookup.condition(given.ends[i].when, here / "end" / i / "when")});
  }
  check_parts(track, here, lookup);
}

void resolve_place(const description::GivenPlace& given, const MadeBy& by, MaterialLookup& lookup, Place& place) {
  const Pointer here = lookup.begin("places", by);
  place.holds = given.holds;
  place.given = by.given;
  place.sensors = sensors(given.sensors, here / "sensors", lookup, nullptr);
}

std::uint64_t most_parts(const Material& material, const Track& track) {
  if (material.kinds.empty()) return 0;
  const auto [shortest, longest] =
      std::minmax_element(material.kinds.begin(), material.kinds.end(),
                          [](const PartKind& a, const PartKind& b) { return a.length < b.length; });
  const std::int64_t least = shortest->length + track.gap;
  if (least == 0) return 0;  // the length is faulty, which is reported
  return static_cast<std::uint64_t>((track.length + longest->length) / least + 1);
}

}  // namespace symplant::model
