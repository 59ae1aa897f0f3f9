// The rules of naming.json.
#pragma once

#include <span>

#include "diag/diagnostic.hpp"

namespace symplant::naming {

/// All of these rules, by id.
std::span<const diag::RuleInfo* const> rules();

}  // namespace symplant::naming
