// Resolves a name in a formula to what it reads of a plant.
#pragma once

#include <variant>

#include "symplant/condition/formula.hpp"

namespace symplant::condition {

/// `operand` is a name, maybe with the number of an output. O(1) look-ups.
std::variant<FormulaInput, Fault> formula_input(const Operand& operand, const Names& names);

}  // namespace symplant::condition
