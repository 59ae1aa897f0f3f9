// The levels that the pattern of an exact rule names.
#pragma once

#include "base/result.hpp"
#include "name/level_rule.hpp"
#include "name/naming.hpp"
#include "name/naming_fault.hpp"

namespace symplant::name {

/// The pattern of an exact rule consists of fields that one separator joins. The pointer of a fault is relative to the
/// rule.
base::Result<LevelRule, NamingFault> exact_levels(const SymbolRule& rule);

}  // namespace symplant::name
