// What moves and holds the parts of tracks: the speeds of their drives, and which stops hold.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "symplant/trace/history.hpp"
#include "symplant/why/conditions.hpp"

namespace symplant::panel {

/// Computes the speeds of drives and the stops from the values of a history. Used by one thread at a time.
class TrackStates {
 public:
  /// Both must outlive it. O(conditions).
  TrackStates(const tables::PlantTables& tables, const trace::History& history);

  /// Looks at all tracks again; calls `changed(track)` for each that differs. `numbers` are the outputs of values.
  /// O(stops, drives, their conditions, and active malfunctions).
  template <class Changed>
  void look(tables::Time now, std::span<const double> numbers, Changed changed) {
    for (std::uint32_t track = 0; track < tracks_.size(); ++track) {
      if (update(track, now, numbers)) changed(track);
    }
  }
  /// Appends `[true,false],[500000]`: for each stop whether it holds, for each drive its speed in um/s.
  void put(std::string& json, std::uint32_t track) const;

 private:
  struct Drive {
    why::Network forward;   ///< empty: never holds
    why::Network backward;  ///< the same
  };
  struct Track {
    std::vector<bool> stops;
    std::vector<std::int64_t> drives;

    bool operator==(const Track&) const = default;
  };

  bool update(std::uint32_t track, tables::Time now, std::span<const double> numbers);
  std::int64_t speed(const tables::DriveRow& row, std::span<const double> numbers) const;
  std::int64_t slowed(std::uint32_t track, std::int64_t speed) const;

  const tables::PlantTables& tables_;
  const trace::History& history_;
  std::vector<why::Network> stops_;  ///< by row of MaterialTables::stops
  std::vector<Drive> drives_;        ///< by row of MaterialTables::drives
  std::vector<Track> tracks_;
};

}  // namespace symplant::panel
