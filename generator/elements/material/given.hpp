// The material flow of a plant description, as the user wrote it: names and conditions are texts.
//
// Lengths are whole micrometers, speeds whole micrometers per second.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "description/duration.hpp"
#include "symplant/tables/material.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::description {

struct GivenKind {
  std::string name;
  std::int64_t length = 0;
  std::uint32_t code = 0;
  double weight = 0;  ///< for values
};

struct GivenSpeed {
  std::int64_t speed = 0;  ///< constant, or what the value 1 of `of` means
  std::string of;          ///< a numeric symbol; empty: the speed is constant
};

struct GivenDrive {
  std::optional<std::int64_t> until;  ///< empty only in the last drive
  std::string forward;                ///< a condition; empty: never holds
  std::string backward;
  GivenSpeed speed;
};

struct GivenStop {
  std::int64_t at = 0;
  std::string when;
};

struct GivenSensor {
  std::string symbol;
  std::optional<std::int64_t> at;  ///< on a track
  std::vector<std::string> kinds;  ///< empty: all
  bool inverted = false;
  tables::SensorReads reads = tables::SensorReads::part;
};

/// An entry of `end`.
struct GivenEnd {
  std::string to;    ///< TRACK, PLACE or `out`
  std::string when;  ///< a condition; empty: always holds
};

/// `of` is the key `for` of tracks, places, transfers, work and sources: a pattern of devices. There is one such
/// element for each device that matches; if `of` is empty, there is one element.
struct GivenTrack {
  std::string name;
  std::string of;
  std::int64_t length = 0;
  std::int64_t gap = 0;
  std::vector<GivenDrive> drives;
  std::vector<GivenStop> stops;
  std::vector<GivenSensor> sensors;
  std::vector<GivenEnd> ends;
};

struct GivenPlace {
  std::string name;
  std::string of;
  std::uint32_t holds = 1;
  std::vector<GivenSensor> sensors;
};

/// Locations are texts: TRACK, TRACK@POSITION, PLACE, or `out` as a target.
struct GivenTransfer {
  std::string name;
  std::string of;
  std::string from;
  std::string to;
  std::string when;  ///< a condition; empty: always holds
  bool once = false;
};

struct GivenWork {
  std::string name;
  std::string of;
  std::string at;
  std::string when;
  std::string from;  ///< a kind
  std::string to;
};

struct GivenSource {
  std::string name;
  std::string of;
  std::string at;
  std::vector<std::string> kinds;  ///< at least one
  std::optional<Duration> every;
  tables::Time first = 0;
  std::string when;
  std::optional<std::uint64_t> count;
};

struct GivenMaterial {
  std::vector<GivenKind> kinds;
  std::vector<GivenTrack> tracks;
  std::vector<GivenPlace> places;
  std::vector<GivenTransfer> transfers;
  std::vector<GivenWork> work;
  std::vector<GivenSource> sources;

  bool empty() const {
    return kinds.empty() && tracks.empty() && places.empty() && transfers.empty() && work.empty() && sources.empty();
  }
};

}  // namespace symplant::description
