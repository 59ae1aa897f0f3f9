// A fixed or random time of a plant description, or one that a formula gives.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "symplant/tables/time.hpp"

namespace symplant::description {

/// A fixed time, or one that is drawn or computed at each use.
struct Duration {
  enum class Kind : std::uint8_t { fixed, uniform, normal, seconds };
  Kind kind = Kind::fixed;
  tables::Time a =
      0;  ///< the time; the minimum; the mean: ns, >= 0; `seconds` of a model: an index in its time_formulas
  tables::Time b = 0;  ///< unused; the maximum, >= a; the standard deviation, >= 0
  /// Of `seconds`, in which equal durations have equal texts.
  std::shared_ptr<const std::string> formula = nullptr;

  static Duration fixed(tables::Time time) { return {Kind::fixed, time, 0}; }
  static Duration seconds(std::string formula) {
    return {Kind::seconds, 0, 0, std::make_shared<const std::string>(std::move(formula))};
  }
  bool is_zero() const { return kind == Kind::fixed && a == 0; }
  friend bool operator==(const Duration& x, const Duration& y) {
    if (x.kind != y.kind) return false;
    return x.kind == Kind::seconds ? *x.formula == *y.formula : x.a == y.a && x.b == y.b;
  }
};

}  // namespace symplant::description
