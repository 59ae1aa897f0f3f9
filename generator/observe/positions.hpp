// Which states of a unit its events can show.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::observe {

/// The events of a unit as levels, a bit each by index in Unit::events.
class Positions {
 public:
  /// `recorded`: by index in PlantModel::symbols.
  Positions(const model::PlantModel& plant, const model::Unit& unit, const std::vector<bool>& recorded);

  /// What levels say of where the unit is.
  enum class Shown : std::uint8_t {
    state,          ///< one state, of which an event is on
    dark,           ///< no event of a state is on: it moves, or is in a state without an event
    contradiction,  ///< the events of several states are on
    unclear,        ///< several states have these levels
  };
  struct Result {
    Shown shown = Shown::dark;
    std::uint32_t state = model::kNone;  ///< valid with Shown::state
  };
  /// `preferred` is the state if it is one of several with these levels. O(states).
  Result at(std::uint64_t levels, std::uint32_t preferred) const;

  /// Whether an event of the state is on in it, so that the arrival shows.
  bool is_lit(std::uint32_t state) const { return signatures_[state].bits != 0; }
  /// Whether levels can be those of the state. O(1).
  bool fits(std::uint32_t state, std::uint64_t levels) const {
    return (levels & signatures_[state].mask) == signatures_[state].bits;
  }
  /// The state in which the unit is if no event is on: kNone if it may be moving, too, or if it may be one of several.
  std::uint32_t dark_state() const { return dark_state_; }
  /// Whether the events that are on when the unit has left a state can be those of a state already: then nothing shows
  /// when it arrives.
  bool misleads() const { return misleads_; }
  /// The level of an event in a state; nothing if the state does not say. O(1).
  std::optional<bool> level(std::uint32_t state, std::uint64_t bit) const {
    if ((signatures_[state].mask & bit) == 0) return std::nullopt;
    return (signatures_[state].bits & bit) != 0;
  }
  /// Whether any event shows a state.
  bool shows_anything() const { return shown_ != 0; }

 private:
  bool shows_at_leaving(std::uint32_t from, std::uint32_t to) const;

  struct Signature {
    std::uint64_t mask = 0;  ///< the events that have a certain level in the state
    std::uint64_t bits = 0;  ///< those that are on
  };
  std::vector<Signature> signatures_;  ///< by state
  std::vector<Signature> left_;        ///< by state: the events when the unit has left it
  bool misleads_ = false;
  std::uint64_t shown_ = 0;  ///< events of states
  std::uint32_t dark_state_ = model::kNone;
};

}  // namespace symplant::observe
