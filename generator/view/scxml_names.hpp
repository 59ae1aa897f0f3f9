// SCXML identifiers of units, states and symbols, and conditions as SCXML expressions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::view {

/// Identifiers that are unique in one document, whatever characters the user's names contain.
class ScxmlNames {
 public:
  explicit ScxmlNames(const model::PlantModel& plant);

  const std::string& unit(std::uint32_t unit) const { return units_[unit]; }
  /// `L_P_D.RUN`
  std::string state(std::uint32_t unit, std::uint32_t state) const { return units_[unit] + "." + states_[unit][state]; }
  /// The event of a symbol's change: `L_P_D_O_RUN.on`.
  std::string change(std::uint32_t symbol, bool on) const { return symbols_[symbol] + (on ? ".on" : ".off"); }
  const std::string& symbol(std::uint32_t symbol) const { return symbols_[symbol]; }
  /// The variable that is true while a unit moves.
  std::string moving(std::uint32_t unit) const { return "moving_" + units_[unit]; }
  /// The variable of a symbol.
  std::string variable(std::uint32_t symbol) const { return "value_" + symbols_[symbol]; }

  /// The variable of the number of parts that an atom compares.
  std::string parts(const condition::Atom& atom) const;

  /// A condition in ECMAScript, not encoded for XML. Adds its variables to `variables`.
  std::string expression(const condition::Tree& tree, std::vector<std::string>& variables) const;

 private:
  /// The variable of a side of a comparison, which is added to `variables`, or a number.
  std::string side(const condition::Quantity& quantity, std::vector<std::string>& variables) const;
  std::string compared(const condition::Atom& atom, std::vector<std::string>& variables) const;

  std::vector<std::string> units_;
  std::vector<std::vector<std::string>> states_;
  std::vector<std::string> symbols_;
  std::vector<std::string> locations_;
  std::vector<std::string> kinds_;
};

}  // namespace symplant::view
