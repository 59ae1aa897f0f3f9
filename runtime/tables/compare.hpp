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

}  // namespace symplant::tables
