// Signals with resolved names.
#pragma once

#include <cstdint>

#include "symplant/condition/formula.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::model {

/// A numeric event that shows a formula.
struct Signal {
  tables::SignalRow row;  ///< without its formula
  condition::Formula formula;
  std::uint32_t given = 0;  ///< index in Description::signals
};

}  // namespace symplant::model
