// Signals, as plant.json gives them.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "symplant/tables/time.hpp"

namespace symplant::description {

/// Writes a formula to a numeric input of the PLC.
struct GivenSignal {
  std::string symbol;  ///< a name, or a pattern
  std::string of;      ///< a formula
  std::optional<std::array<double, 2>> from;
  std::optional<std::array<double, 2>> to;
  std::optional<std::array<double, 2>> limit;
  double noise = 0;  ///< the standard deviation
  std::optional<tables::Time> every;
};

}  // namespace symplant::description
