// A fixed or random time of a plant description.
#pragma once

#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::description {

/// A fixed time, or a random one that is drawn at each use.
struct Duration {
  enum class Kind : std::uint8_t { fixed, uniform, normal };
  Kind kind = Kind::fixed;
  tables::Time a = 0;  ///< the time; the minimum; the mean: ns, >= 0
  tables::Time b = 0;  ///< unused; the maximum, >= a; the standard deviation, >= 0

  static Duration fixed(tables::Time time) { return {Kind::fixed, time, 0}; }
  bool is_zero() const { return kind == Kind::fixed && a == 0; }
  friend bool operator==(const Duration&, const Duration&) = default;
};

}  // namespace symplant::description
