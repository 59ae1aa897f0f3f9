// Symbols that follow a resolved condition.
#pragma once

#include <cstdint>
#include <optional>

#include "symplant/condition/tree.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::model {

/// A BOOL event that no unit drives and that follows a condition.
struct Follow {
  std::uint32_t symbol = tables::kNone;
  condition::Tree condition;
  std::optional<condition::Tree> off;  ///< it is switched off while this holds
  std::uint32_t given = 0;             ///< index in Description::follow
};

}  // namespace symplant::model
