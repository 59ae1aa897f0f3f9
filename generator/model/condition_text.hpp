// Writes a condition as a text of a description: the inverse of condition::resolve().
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "model/plant_model.hpp"
#include "symplant/condition/tree.hpp"

namespace symplant::model {

/// `L_P_AGV.P2 and not (L_P_DOOR.OPEN1 or LEVEL > 5)`: names that are not identifiers in quotes, parentheses only where
/// the tree needs them. Parsed and resolved against the same plant, the text gives the same tree. A text of more than
/// `longest` bytes is cut after a whole character, with ` ...` at its end. Names are as the user wrote them, not
/// encoded. A constant is written as a comparison that every value of its symbol meets, or no value; without a symbol
/// as `always` or `never`. O(text).
std::string condition_text(const condition::Tree& tree, const PlantModel& plant,
                           std::size_t longest = std::string::npos);

/// `<`, `<=`, `=`, `>=`, `>`.
std::string_view comparison_text(tables::Comparison comparison);

/// The number that an atom compares with.
std::string operand_text(const condition::Atom& atom);

}  // namespace symplant::model
