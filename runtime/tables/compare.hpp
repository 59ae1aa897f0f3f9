// How a numeric symbol compares with a number.
#pragma once

#include <bit>
#include <cstdint>

#include "symplant/tables/tables.hpp"

namespace symplant::tables {

template <class Number>
constexpr bool compares(Number value, Comparison comparison, Number operand) noexcept {
  switch (comparison) {
    case Comparison::less:
      return value < operand;
    case Comparison::less_equal:
      return value <= operand;
    case Comparison::equal:
      return value == operand;
    case Comparison::greater_equal:
      return value >= operand;
    case Comparison::greater:
      return value > operand;
  }
  return false;
}

/// The 64 bits of a slot as a double, rounded to the nearest one.
inline double number_of(NumberKind kind, std::uint64_t value) noexcept {
  switch (kind) {
    case NumberKind::signed_integer:
      return static_cast<double>(static_cast<std::int64_t>(value));
    case NumberKind::unsigned_integer:
      return static_cast<double>(value);
    case NumberKind::real:
      break;
  }
  return std::bit_cast<double>(value);
}

/// Whether a slot's value meets the watch's comparison. Every comparison with NaN is false.
inline bool holds(const ValueWatch& watch, std::uint64_t value) noexcept {
  switch (watch.kind) {
    case NumberKind::signed_integer:
      return compares(static_cast<std::int64_t>(value), watch.comparison, static_cast<std::int64_t>(watch.operand));
    case NumberKind::unsigned_integer:
      return compares(value, watch.comparison, watch.operand);
    case NumberKind::real:
      return compares(std::bit_cast<double>(value), watch.comparison, std::bit_cast<double>(watch.operand));
  }
  return false;
}

/// Whether two operands compare. `equal` holds from `right - tolerance` to `right + tolerance`, for other comparisons
/// the tolerance is 0. Every comparison with NaN is false.
inline bool compares_near(double left, Comparison comparison, double right, double tolerance) noexcept {
  if (comparison != Comparison::equal) return compares(left, comparison, right);
  return left >= right - tolerance && left <= right + tolerance;
}

}  // namespace symplant::tables
