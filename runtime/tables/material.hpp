// The tables of material flow: parts on tracks and in places (docs/material.md).
//
// Lengths and positions are whole micrometers. A location is the index of a track, or the number of tracks plus the
// index of a place.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::tables {

inline constexpr std::uint32_t kOut = 0xFFFF'FFFF;         ///< a location: the part leaves the plant
inline constexpr std::int64_t kWhole = -1;                 ///< of a location: no position is given
inline constexpr std::int64_t kMaxLength = 1'000'000'000;  ///< 1 km, in um
inline constexpr std::int64_t kMaxSpeed = 100'000'000;     ///< 100 m/s, in um/s
inline constexpr std::uint32_t kMaxPartsOnTrack = 1000;
inline constexpr std::uint32_t kMaxPartsInPlace = 1000;

/// Consecutive rows of another table.
struct Rows {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  friend bool operator==(const Rows&, const Rows&) = default;
};

struct KindRow {
  std::int64_t length = 0;  ///< > 0
  std::uint32_t code = 0;   ///< up to 65,535
  double weight = 0;        ///< for formulas
};

struct TrackRow {
  std::int64_t length = 0;  ///< > 0
  std::int64_t gap = 0;     ///< smallest distance between two parts, >= 0
  Rows drives;              ///< in order along the track, at least one
  Rows stops;
  Rows sensors;
  Rows ends;  ///< in priority order; none: a hard end
};

/// A range of a track in which one motor moves the parts. It begins at the `until` of the drive before it.
struct DriveRow {
  std::int64_t until = 0;      ///< the length of the track for its last drive
  std::uint32_t forward = 0;   ///< a condition; kNone: never holds, but always if `symbol` is given and both are kNone
  std::uint32_t backward = 0;  ///< a condition; kNone: never holds
  std::uint32_t symbol = 0;    ///< a numeric symbol that gives the speed; kNone: it is constant
  std::int64_t speed = 0;      ///< um/s, > 0: the speed, or what the value 1 of `symbol` or `output` means
  std::uint32_t output = 0xFFFF'FFFF;  ///< an output of a value that gives the speed; kNone: none does

  /// Whether the speed is not constant.
  constexpr bool varies() const noexcept { return symbol != 0xFFFF'FFFF || output != 0xFFFF'FFFF; }
  /// Whether its speed alone says where it moves.
  constexpr bool always_forward() const noexcept {
    return varies() && forward == 0xFFFF'FFFF && backward == 0xFFFF'FFFF;
  }
};

/// While its condition holds, no part passes.
struct StopRow {
  std::int64_t at = 0;
  std::uint32_t condition = 0;
};

enum class SensorReads : std::uint8_t {
  part,    ///< BOOL: whether a part covers it
  code,    ///< numeric: the code of the front-most covering part's kind, 0 without one
  number,  ///< numeric: that part's number
};

struct SensorRow {
  std::uint32_t symbol = 0;
  std::uint32_t location = 0;
  std::int64_t at = 0;  ///< on a track; unused in a place
  Rows kinds;           ///< of sensor_kinds: the kinds that it sees; none: all
  SensorReads reads = SensorReads::part;
};

struct EndRow {
  std::uint32_t to = 0;         ///< a location, or kOut
  std::uint32_t condition = 0;  ///< kNone: always holds
};

struct PlaceRow {
  std::uint32_t holds = 0;  ///< 1 to kMaxPartsInPlace
  Rows sensors;
};

/// A location, and a position on a track or kWhole.
struct PartLocation {
  std::uint32_t location = kOut;
  std::int64_t at = kWhole;

  friend bool operator==(const PartLocation&, const PartLocation&) = default;
};

struct TransferRow {
  PartLocation from;
  PartLocation to;
  std::uint32_t condition = 0;  ///< kNone: always holds
  bool once = false;            ///< one part for each beginning of the condition
};

struct WorkRow {
  PartLocation at;
  std::uint32_t condition = 0;
  std::uint32_t from = 0;  ///< a kind
  std::uint32_t to = 0;    ///< a kind of the same length
};

inline constexpr std::uint64_t kAnyNumber = 0xFFFF'FFFF'FFFF'FFFF;

struct SourceRow {
  PartLocation to;
  Rows kinds;      ///< of source_kinds, taken in turn; at least one
  Time first = 0;  ///< >= 0
  /// >= 1; 0: not given. A negative number n refers to PlantTables::random_times[-1 - n].
  Time every = 0;
  std::uint64_t count = 0;      ///< kAnyNumber: not given
  std::uint32_t condition = 0;  ///< kNone: always holds
};

/// A number of parts that conditions read. Their ValueWatch::slot is the index of such a row.
struct PartCounterRow {
  std::uint32_t location = 0;
  std::uint32_t kind = 0;  ///< kNone: parts of all kinds
};

/// Empty in a plant without material.
struct MaterialTables {
  std::span<const KindRow> kinds;
  std::span<const TrackRow> tracks;
  std::span<const DriveRow> drives;  ///< in the order of their tracks; so are the next three
  std::span<const StopRow> stops;
  std::span<const EndRow> ends;
  std::span<const SensorRow> sensors;  ///< those of tracks, then those of places
  std::span<const PlaceRow> places;
  std::span<const TransferRow> transfers;
  std::span<const WorkRow> work;
  std::span<const SourceRow> sources;
  std::span<const std::uint32_t> sensor_kinds;
  std::span<const std::uint32_t> source_kinds;
  std::span<const PartCounterRow> counters;
  std::string_view kind_names;      ///< a kind: its name
  std::string_view location_names;  ///< a track, then a place: its name
  std::string_view transfer_names;
  std::string_view work_names;
  std::string_view source_names;

  bool empty() const noexcept { return tracks.empty() && places.empty(); }
  std::uint32_t locations() const noexcept { return static_cast<std::uint32_t>(tracks.size() + places.size()); }
  bool is_track(std::uint32_t location) const noexcept { return location < tracks.size(); }
  std::uint32_t place_of(std::uint32_t location) const noexcept {
    return location - static_cast<std::uint32_t>(tracks.size());
  }
};

/// The most parts that fit on a track: floor((length + longest kind) / (shortest kind + gap)) + 1, at most
/// kMaxPartsOnTrack. O(kinds).
inline std::uint32_t most_parts(const MaterialTables& material, const TrackRow& track) noexcept {
  if (material.kinds.empty()) return 0;
  const auto [shortest, longest] =
      std::minmax_element(material.kinds.begin(), material.kinds.end(),
                          [](const KindRow& a, const KindRow& b) { return a.length < b.length; });
  const std::int64_t most = (track.length + longest->length) / (shortest->length + track.gap) + 1;
  return static_cast<std::uint32_t>(std::min<std::int64_t>(most, kMaxPartsOnTrack));
}

}  // namespace symplant::tables
