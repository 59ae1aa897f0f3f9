// Works out a formula in postfix form, to the same bits everywhere.
#pragma once

#include <cstdint>
#include <span>

#include "symplant/tables/value.hpp"

namespace symplant::tables {

/// How many numbers an operation takes from the stack, 0 to 3; it pushes one. O(1).
std::uint32_t operands_of(FormulaOp op) noexcept;

/// The result of a formula: IEEE 754 doubles, each operation rounded to nearest, in the order of the steps.
///
/// `numbers` has the points of curves. `inputs` are the values of the inputs that the steps name. The steps must leave
/// one number, and never more than kMostFormulaDepth at a time. O(steps), with O(log points) for each curve.
double evaluate(std::span<const FormulaStep> steps, std::span<const double> numbers, const double* inputs) noexcept;

// The functions of formulas that the C library does not have, for code that works out formulas without steps.

double formula_sign(double x) noexcept;   ///< 1, -1, or x itself for 0 and NaN
double formula_round(double x) noexcept;  ///< half to even
double formula_min(double a, double b) noexcept;
double formula_max(double a, double b) noexcept;
double formula_wrap(double x, double low, double high) noexcept;
double formula_limit(double x, double low, double high) noexcept;
/// `points`: x and y of each, at least two, ascending in x. O(log points).
double formula_curve(double x, std::span<const double> points) noexcept;

}  // namespace symplant::tables
