// How the devices of a plant were used: the time in each state, moves and cycles, from the records of a run.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "symplant/trace/history.hpp"
#include "symplant/trace/intervals.hpp"
#include "symplant/trace/malfunction_marks.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"
#include "symplant/trace/unit_activity.hpp"
#include "symplant/trace/utilization_parts.hpp"

namespace symplant::trace {

/// Moves of a device from one state to another.
struct MoveUse {
  std::uint8_t from = 0;
  std::uint8_t to = 0;
  tables::Time time = 0;  ///< spent between the two states, ns
  Durations whole;        ///< of those that began at rest and arrived; a change at once takes 0
};

/// The times from one entry into a state to the next entry.
struct CycleUse {
  std::uint8_t state = 0;
  Durations times;
};

/// A device since the counting began. Times are in ns.
struct DeviceUse {
  std::array<tables::Time, kActivities> times{};  ///< by Activity; their sum is the time since
  tables::Time malfunction = 0;                   ///< a malfunction acted on it
  std::vector<tables::Time> states;  ///< settled in each; with the times of `moves` the sum is the time since
  std::vector<MoveUse> moves;
  std::optional<CycleUse>
      cycle;  ///< of its initial state if it entered this twice, else of the state with most entries

  std::uint64_t arrivals() const {
    std::uint64_t count = 0;
    for (const MoveUse& move : moves) count += move.whole.count;
    return count;
  }
};

/// Follows the records of a run together with a History. Used by one thread at a time. Takes 150 bytes for a unit, 80
/// for each of its states and 60 for each of its transitions.
class Utilization {
 public:
  /// Both must outlive it. Counts from time 0.
  Utilization(const PlantNames& names, const History& history);

  /// Counts again from `time`, with what the history has; records of earlier times add nothing. O(plant).
  void begin(tables::Time time);
  /// Before begin(), if the plant was set to another state. O(plant).
  void load(const plant::Plant& plant) { parts_.load(plant); }
  /// To be called after History::apply(), for all records but notes. O(symbols of the device).
  void apply(const Record& record);

  const PlantNames& names() const { return names_; }
  /// When the counting began.
  tables::Time from() const { return from_; }
  /// Until `now`, which is not before the last record. O(states and transitions of the device).
  DeviceUse device(std::uint32_t unit, tables::Time now) const;
  const PartUtilization& parts() const { return parts_; }

 private:
  struct Unit {
    tables::Time at = 0;  ///< until when it is counted
    std::array<tables::Time, kActivities> times{};
    tables::Time malfunction = 0;
    tables::Time started = -1;  ///< of its move, if it began at rest; -1: unknown
    tables::Time due = 0;       ///< when its move arrives if it goes on, rounded down to 1 us
    std::vector<MoveUse> moves;
    std::uint32_t move = 0;  ///< the index of its present move
    Activity activity = Activity::rest;
    std::uint8_t state = 0;
    std::uint8_t target = 0;
    bool moving = false;
  };
  struct State {
    tables::Time time = 0;
    Intervals entries;
  };
  void count(std::uint32_t unit, tables::Time time);
  void follow(std::uint32_t unit, const Record& record);
  void leave_move(std::uint32_t unit, const plant::UnitView& view, tables::Time time);
  void enter(std::uint32_t unit, std::uint8_t state, tables::Time time);
  void malfunction(const Record& record);
  static std::uint32_t move_of(Unit& unit, std::uint8_t from, std::uint8_t to);
  std::optional<CycleUse> cycle(std::uint32_t unit) const;

  const PlantNames& names_;
  const History& history_;
  tables::Time from_ = 0;
  std::vector<Unit> units_;
  std::vector<State> states_;               ///< of each unit
  std::vector<std::uint32_t> first_state_;  ///< by unit: its first in `states_`; one more at the end
  MalfunctionMarks malfunctions_;
  PartUtilization parts_;
};

}  // namespace symplant::trace
