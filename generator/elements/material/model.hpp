// The material flow of a plant with resolved names: parts on tracks and in places (docs/material.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "description/duration.hpp"
#include "symplant/condition/tree.hpp"
#include "symplant/tables/material.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::model {

/// Lengths are whole micrometers, speeds whole micrometers per second. Locations and kinds are numbered as in
/// tables::MaterialTables; `given` is the index of an entry in the list of the description, and several elements have
/// the same one if it has a `for`.
struct PartKind {
  std::string name;
  std::int64_t length = 0;
  std::uint32_t code = 0;
  double weight = 0;
};

struct Drive {
  std::int64_t until = 0;                   ///< the length of the track for the last one
  std::optional<condition::Tree> forward;   ///< empty: never holds
  std::optional<condition::Tree> backward;  ///< empty: never holds
  std::int64_t speed = 0;                   ///< > 0: the speed, or what the value 1 of `symbol` or `output` means
  std::uint32_t symbol = 0xFFFF'FFFF;       ///< a numeric symbol that gives the speed; kNone: none does
  std::uint32_t output = 0xFFFF'FFFF;       ///< an output of a value that gives it; kNone: none does

  /// Whether the speed is not constant.
  bool varies() const { return symbol != 0xFFFF'FFFF || output != 0xFFFF'FFFF; }
};

/// The number that gives its speed alone says how it moves: always forward, backward if the value is negative.
inline bool runs_always(const Drive& drive) { return drive.varies() && !drive.forward && !drive.backward; }

struct Stop {
  std::int64_t at = 0;
  condition::Tree condition;
};

struct PartSensor {
  std::uint32_t symbol = 0;
  std::int64_t at = 0;               ///< on a track
  std::vector<std::uint32_t> kinds;  ///< those that it sees, ascending; empty: all
  tables::SensorReads reads = tables::SensorReads::part;
};

struct TrackEnd {
  std::uint32_t to = tables::kOut;           ///< a location, or kOut
  std::optional<condition::Tree> condition;  ///< empty: always holds
};

struct Track {
  std::string name;
  std::int64_t length = 0;
  std::int64_t gap = 0;
  std::vector<Drive> drives;  ///< at least one
  std::vector<Stop> stops;
  std::vector<PartSensor> sensors;
  std::vector<TrackEnd> ends;
  std::uint32_t given = 0;
};

struct Place {
  std::string name;
  std::uint32_t holds = 1;
  std::vector<PartSensor> sensors;
  std::uint32_t given = 0;
};

struct Transfer {
  std::string name;
  tables::PartLocation from;
  tables::PartLocation to;
  std::optional<condition::Tree> condition;
  bool once = false;
  std::uint32_t given = 0;
};

struct Work {
  std::string name;
  tables::PartLocation at;
  condition::Tree condition;
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t given = 0;
};

struct Source {
  std::string name;
  tables::PartLocation to;
  std::vector<std::uint32_t> kinds;  ///< taken in turn; at least one
  std::optional<description::Duration> every;
  tables::Time first = 0;
  std::optional<std::uint64_t> count;
  std::optional<condition::Tree> condition;
  std::uint32_t given = 0;
};

struct Material {
  std::vector<PartKind> kinds;
  std::vector<Track> tracks;
  std::vector<Place> places;
  std::vector<Transfer> transfers;
  std::vector<Work> work;
  std::vector<Source> sources;

  bool empty() const { return tracks.empty() && places.empty(); }
  /// The number of tracks and places.
  std::uint32_t locations() const { return static_cast<std::uint32_t>(tracks.size() + places.size()); }
  bool is_track(std::uint32_t location) const { return location < tracks.size(); }
  const std::string& location_name(std::uint32_t location) const {
    return is_track(location) ? tracks[location].name : places[location - tracks.size()].name;
  }
};

/// The most parts that fit on a track: floor((length + longest kind) / (shortest kind + gap)) + 1.
std::uint64_t most_parts(const Material& material, const Track& track);

}  // namespace symplant::model
