// Works out a formula in postfix form, to the same bits everywhere.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
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

}  // namespace symplant::tables

/// The functions of formulas, for code that works them out without steps: the same bits as evaluate(). Those that other
/// optimizations could change are calls into the library, which is compiled to keep them.
namespace symplant::tables::formula {

inline double truth(bool is_true) noexcept { return is_true ? 1.0 : 0.0; }

inline double abs(double x) noexcept { return std::fabs(x); }
inline double sign(double x) noexcept { return x > 0 ? 1.0 : x < 0 ? -1.0 : x; }  ///< x itself for 0 and NaN
inline double floor(double x) noexcept { return std::floor(x); }
inline double ceil(double x) noexcept { return std::ceil(x); }
inline double round(double x) noexcept { return std::nearbyint(x); }  ///< half to even
inline double sqrt(double x) noexcept { return std::sqrt(x); }

inline double min(double a, double b) noexcept { return b < a ? b : a; }
inline double max(double a, double b) noexcept { return a < b ? b : a; }
inline double limit(double x, double low, double high) noexcept { return min(max(x, low), high); }

// The functions of the C library.
double exp(double x) noexcept;
double ln(double x) noexcept;
double sin(double x) noexcept;
double cos(double x) noexcept;
double tan(double x) noexcept;
double asin(double x) noexcept;
double acos(double x) noexcept;
double atan(double x) noexcept;
double pow(double x, double y) noexcept;
double mod(double x, double y) noexcept;  ///< fmod
double atan2(double y, double x) noexcept;

double wrap(double x, double low, double high) noexcept;  ///< x - (high - low) * floor((x - low) / (high - low))

/// `points`: x and y of each, at least two, ascending in x. O(log points).
double curve(double x, std::span<const double> points) noexcept;
inline double curve(double x, std::initializer_list<double> points) noexcept {
  return curve(x, std::span<const double>(points.begin(), points.size()));
}

}  // namespace symplant::tables::formula
