// Resolves the given transitions and outputs of a unit.
#pragma once

#include <vector>

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// The derived and inferred transitions that given ones replace. Empty if none are given.
class GivenTransitions {
 public:
  GivenTransitions() = default;
  explicit GivenTransitions(const Unit& unit);  ///< of the transitions that the unit has so far

  bool commanded(std::uint32_t from, std::uint32_t on) const {
    return !commanded_.empty() && commanded_[from * operations_ + on];
  }
  bool automatic(std::uint32_t from, std::uint32_t to) const {
    return !automatic_.empty() && automatic_[from * states_ + to];
  }
  /// Whether a commanded transition leads to a state.
  bool led_to(std::uint32_t to) const { return !led_to_.empty() && led_to_[to]; }

 private:
  std::size_t operations_ = 0;
  std::size_t states_ = 0;
  std::vector<bool> commanded_;
  std::vector<bool> automatic_;
  std::vector<bool> led_to_;
};

/// Adds the given transitions to the unit, with `*` expanded. States, actuation, rest and initial state of the unit
/// must be known. Transition::when and Transition::during count the different texts of `when` and `while` in the order
/// of first appearance.
void add_given_transitions(Unit& unit, const std::vector<Symbol>& symbols, description::Faults& faults);

/// Fills Unit::outputs.
void add_outputs(Unit& unit, const std::vector<Symbol>& symbols, description::Faults& faults);

/// The index of a state; kNone, and a fault at `pointer`, if it is not found.
std::uint32_t given_state(const Unit& unit, std::string_view name, const description::Pointer& pointer,
                          description::Faults& faults);

}  // namespace symplant::model
