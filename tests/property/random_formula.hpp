// Random formulas of values, and conditions that compare values.
#pragma once

#include <string>
#include <vector>

#include "property/dice.hpp"
#include "property/plant_text.hpp"

namespace symplant::property {

/// What formulas may name.
struct FormulaNames {
  std::vector<std::string> values;   ///< outputs that every formula may read
  std::vector<std::string> plant;    ///< states, bits, numeric symbols, parts
  std::vector<std::string> numbers;  ///< numeric symbols, for comparisons
  std::vector<std::string> truths;   ///< atoms of conditions
};

FormulaNames formula_names(const model::PlantModel& model);

/// A formula of about `size` operands.
std::string random_formula(Dice& dice, const FormulaNames& names, std::size_t size);
/// A number from a small grid, never negative, as a text.
std::string random_literal(Dice& dice);
/// A comparison of two operands, one of which is a value if there is one.
std::string random_comparison(Dice& dice, const FormulaNames& names);
/// A condition of one or two atoms.
std::string random_value_condition(Dice& dice, const FormulaNames& names);

}  // namespace symplant::property
