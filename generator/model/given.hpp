// What the description says of one unit's transitions and outputs.
#pragma once

#include <vector>

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Which derived and inferred transitions the given ones replace. Empty where none are given.
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
  /// Some commanded one leads there.
  bool led_to(std::uint32_t to) const { return !led_to_.empty() && led_to_[to]; }

 private:
  std::size_t operations_ = 0;
  std::size_t states_ = 0;
  std::vector<bool> commanded_;
  std::vector<bool> automatic_;
  std::vector<bool> led_to_;
};

/// Puts the given transitions into the unit's table, `*` expanded. States, actuation, rest and initial state of the
/// unit are known. Transition::when counts the different texts of `when` in the order of their first appearance.
void add_given_transitions(Unit& unit, const std::vector<Symbol>& symbols, description::Faults& faults);

/// Fills Unit::outputs.
void add_outputs(Unit& unit, const std::vector<Symbol>& symbols, description::Faults& faults);

/// The place of a state; kNone, and a fault at `pointer`, where there is none of that name.
std::uint32_t given_state(const Unit& unit, std::string_view name, const description::Pointer& pointer,
                          description::Faults& faults);

}  // namespace symplant::model
