// Values with resolved names.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/condition/formula.hpp"
#include "symplant/condition/tree.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::model {

/// A jump: when the condition begins to hold, the output becomes the result of the formula.
struct Change {
  condition::Tree when;
  condition::Formula to;
};

/// A number that changes with time.
struct Value {
  std::string name;
  std::string unit;                          ///< for people
  tables::ValueRow row;                      ///< without its formulas, numbers and changes
  std::vector<condition::Formula> formulas;  ///< as ValueRow::formula says
  std::vector<double> numbers;               ///< as ValueRow::numbers says
  std::vector<Change> changes;
  std::uint32_t given = 0;                ///< index in Description::values
  std::uint32_t matched = tables::kNone;  ///< a unit of the device that `for` matched; kNone: none
};

}  // namespace symplant::model
