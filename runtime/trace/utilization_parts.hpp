// How tracks, places and exits were used by parts, from the records of a run.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "symplant/trace/history.hpp"
#include "symplant/trace/intervals.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::trace {

/// What a track or place is, of which exactly one holds at each time.
enum class Occupation : std::uint8_t {
  used,     ///< it has parts, and none of the following holds
  blocked,  ///< a part is at rest at the end of the track, or no work is left for the first part of a place with work
  empty,    ///< it has no part
};
inline constexpr std::size_t kOccupations = 3;
inline constexpr std::array<std::string_view, kOccupations> kOccupationNames{"used", "blocked", "empty"};

/// A track or place since the counting began.
struct LocationUse {
  std::array<tables::Time, kOccupations> times{};  ///< ns by Occupation; their sum is the time since
  bool starves = false;    ///< something takes parts from there or works on them, so that it starves while it is empty
  std::uint64_t came = 0;  ///< parts
  std::uint64_t left = 0;  ///< parts
  Intervals exits;         ///< parts that left the plant from there, not by hand
};

/// Used by one thread at a time. The History must have the motions of parts on tracks, or no track counts as blocked.
class PartUtilization {
 public:
  /// Both must outlive it.
  PartUtilization(const tables::MaterialTables& material, const History& history);

  /// Counts from `time`, with the parts that the history has. O(plant).
  void begin(tables::Time time);
  /// Takes from the plant what the history does not have: which tracks have a part at rest at their end. O(plant).
  void load(const plant::Plant& plant);
  /// To be called after History::apply(). O(1).
  void apply(const Record& record);
  /// Until `now`. O(1).
  LocationUse location(std::uint32_t location, tables::Time now) const;
  /// All parts that left the plant, not by hand.
  const Intervals& exits() const { return exits_; }

 private:
  struct Location {
    tables::Time at = 0;  ///< until when it is counted
    LocationUse use;
    Occupation now = Occupation::empty;
    bool at_end = false;           ///< of a track: its first part is at rest at its end
    std::vector<bool> work_takes;  ///< of a place: by kind; empty: it has no work
  };
  void count(Location& location, tables::Time time) const;
  void look_at(std::uint32_t location, tables::Time time);
  void move(const PartRecord& part);
  Occupation occupation(std::uint32_t location) const;

  const tables::MaterialTables& material_;
  const History& history_;
  std::vector<Location> locations_;
  std::unordered_map<std::uint64_t, std::uint32_t> location_of_;  ///< of each part in the plant
  Intervals exits_;
  Record part_;                          ///< the last record of a part, whose part_move is next
  std::uint32_t track_ = tables::kNone;  ///< whose first part is in the next record
};

}  // namespace symplant::trace
