// Which states a plant comes into by itself and by its PLC's commands.
#pragma once

#include <cstdint>
#include <vector>

#include "check/reachability/decide.hpp"
#include "model/plant_model.hpp"

namespace symplant::check {

/// Why a transition is never taken.
enum class Blocked : std::uint8_t {
  no,
  contradiction,  ///< its condition can never hold, whatever the plant does
  waits,          ///< its condition needs a state that nothing leads to
  overtaken,      ///< an automatic transition without condition and time leaves its state before
};

/// Starts from the initial states and goes on until nothing new is reached. Whatever the PLC may write counts as
/// written, units without a driver and those with a user's behaviour may be in every state: what is
/// *not* reached is certain, unless a scenario, a trainer or another hand puts a unit there.
class Reach final : public Possible {
 public:
  /// The plant's description must be without faults. O(transitions, and for each state reached the conditions that name
  /// its unit).
  explicit Reach(const model::PlantModel& plant);

  bool settled(std::uint32_t unit, std::uint32_t state) const override { return reached_[unit][state]; }
  bool moving(std::uint32_t unit) const override;

  Blocked blocked(std::uint32_t unit, const model::Transition& transition) const;
  /// Whether anything leads out of a state once it is reached: a transition that is not blocked, or a spring's return.
  bool can_leave(std::uint32_t unit, std::uint32_t state) const;

 private:
  struct Location {
    std::uint32_t unit;
    std::uint32_t state;
  };

  void start(std::uint32_t unit);
  void reach(std::uint32_t unit, std::uint32_t state);
  void go_on_from(const Location& location);
  void ask_again(std::uint32_t about);
  void find_overtakers(std::uint32_t unit);
  bool may_hold(const model::Unit& unit, std::uint32_t condition) const;

  const model::PlantModel& plant_;
  std::vector<std::vector<bool>> reached_;          // a unit, a state
  std::vector<std::vector<std::uint32_t>> asking_;  // a unit -> units with conditions that name it
  /// A unit, a state: the transition that overtakes others, by index in Unit::transitions, or kNone. Empty where a unit
  /// has no such transition.
  std::vector<std::vector<std::uint32_t>> overtakers_;
  std::vector<Location> open_;  // reached and not yet gone on from
};

}  // namespace symplant::check
