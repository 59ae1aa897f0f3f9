// Requirements with resolved conditions.
#pragma once

#include <cstdint>
#include <string>

#include "symplant/condition/tree.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::model {

/// A requirement with resolved conditions: `never`, or `after` and `expect`.
struct Requirement {
  std::string name;
  tables::RequirementRow::Kind kind = tables::RequirementRow::Kind::never;
  condition::Tree condition;  ///< of `never`, or of `after`
  condition::Tree expected;   ///< of `expect`
  tables::Time within = 0;
  tables::Time earliest = 0;  ///< when `expected` may hold at the earliest, counted as `within`
  std::uint32_t given = 0;    ///< index in Description::requirements
};

}  // namespace symplant::model
