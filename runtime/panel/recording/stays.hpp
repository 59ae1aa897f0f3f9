// Where the parts of a trace were on their tracks.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::panel {

/// The fronts of parts on tracks, estimated: a part is known to be where it came, at the position of a sensor when that
/// begins or ends to see it, and at the end of its track when it leaves. In between it moves evenly, or waits at a stop
/// if it took longer than its drive needs. Parts do not overtake each other, so the next part that a sensor sees is the
/// foremost that has not passed it.
class Stays {
 public:
  /// O(records + changes of sensors * parts on their track).
  Stays(const std::vector<trace::Record>& records, const trace::PlantNames& names);

  /// When parts change their speed, and on which track: rising times. O(pins * log(pins)).
  std::vector<std::pair<tables::Time, std::uint32_t>> turns() const;
  /// Appends the records of a track's parts at a time, from the front. `time` must not be before that of the previous
  /// call. O(parts there).
  void append(std::uint32_t track, tables::Time time, std::vector<trace::Record>& records);

 private:
  /// A front was at a position, in um.
  struct Pin {
    tables::Time time;
    std::int64_t x;
  };
  struct Stay {
    std::uint64_t number = 0;
    std::uint32_t kind = 0;
    tables::Time to = tables::kNever;
    std::vector<Pin> pins;  ///< the first one is where the part came; times and positions rise
  };

  struct Track {
    std::vector<Stay> stays;  ///< in the order in which they began
    std::size_t first = 0;    ///< those before it have ended
  };

  void moved(const trace::PartRecord& part);
  void seen(const trace::Record& change);
  std::int64_t speed_at(std::uint32_t track, std::int64_t x) const;
  void hold_at_stop(std::uint32_t track, Stay& stay, Pin next) const;
  void pin(std::uint32_t track, Stay& stay, Pin next) const;
  /// The stays from the first one that has not ended at a time.
  static std::span<Stay> since(Track& track, tables::Time time);
  static std::pair<std::int64_t, std::int32_t> front(const Stay& stay, tables::Time time);

  const trace::PlantNames& names_;
  std::map<std::uint32_t, std::uint32_t> sensors_;  ///< a BOOL symbol -> its sensor, on tracks
  std::map<std::uint32_t, Track> tracks_;
  std::map<std::uint64_t, std::pair<std::uint32_t, std::size_t>> open_;  ///< a part -> its stay
};

}  // namespace symplant::panel
