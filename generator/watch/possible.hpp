// What a unit may have done by its model, although no reading shows it.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <vector>

#include "model/plant_model.hpp"
#include "observe/observer.hpp"
#include "watch/limits.hpp"
#include "watch/statistics.hpp"

namespace symplant::watch {

/// The doubts that a watcher has before it reports an anomaly. O(transitions) each, unless noted.
class Possible {
 public:
  /// `recorded`: by symbol. `learned`: if there is any, times that were neither given nor learned are not known.
  /// Everything given must outlive it, except `learned`.
  Possible(const model::PlantModel& plant, const std::vector<bool>& recorded, const observe::Observer& observer,
           const Margin& margin, const std::vector<Statistic>& learned);

  /// Not known for a unit with custom code, and where nothing was learned. O(1), for a spring's return O(transitions).
  Limits limits(const observe::Move& move) const;
  /// Whether a recorded event is on in the state; false for kNone. O(outputs of the state).
  bool shows(const model::Unit& unit, std::uint32_t state) const;
  bool shows_all(const model::Unit& unit) const;

  /// Whether a move without a known cause may have had one that is not recorded. `canceled`: the last move whose cause
  /// ended before the unit left; the unit may have begun to move all the same. O(1).
  bool may_have_cause(const observe::Move& move, const observe::Move& canceled) const;
  /// Whether a change of an operation to `on` causes this move, or may cause one from its state.
  bool is_cause(const observe::Move& move, std::uint32_t symbol, bool on) const;
  /// Whether its command, which a program ends when the unit has arrived, or a state by which it came, was there
  /// between two readings only. O(transitions^2).
  bool hides_cause(const observe::Move& move) const;
  /// How much longer than by its limits a unit shows no state if it left that of `move.to` between two readings.
  Time longer_by(const observe::Move& move) const;
  /// Whether no event shows `move.from`, and the unit has hardly had the time to come to rest there.
  bool may_begin_midway(const observe::Move& move) const;
  /// Whether something that is not known may have stopped it: a condition of `while`, or a unit that disables it.
  bool may_be_stopped(const observe::Move& move) const;

  /// The units that the conditions of a unit read, and those that disable it. O(1).
  const std::vector<std::uint32_t>& causes_of(std::uint32_t unit) const { return causes_[unit]; }

 private:
  /// Whether it came by a state that it left between two readings, in the time that this takes.
  bool passes_through(const observe::Move& move) const;
  std::optional<Range> onward(const model::Unit& unit, std::uint32_t transition) const;
  bool is_known(const condition::Tree& tree) const;
  /// Whether the times of a move are more than the default of the model.
  bool is_judged(const observe::Move& move) const;

  const model::PlantModel& plant_;
  const std::vector<bool>& recorded_;
  const observe::Observer& observer_;
  const Margin margin_;
  std::vector<std::vector<std::uint32_t>> causes_;     ///< by unit
  std::vector<std::vector<std::uint32_t>> disablers_;  ///< by unit
  std::set<std::array<std::uint32_t, 3>> learned_;     ///< unit, from, to; empty: times were not learned
};

}  // namespace symplant::watch
