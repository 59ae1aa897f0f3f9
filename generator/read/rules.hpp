// The rules of reading.
#pragma once

#include <span>

#include "diag/diagnostic.hpp"

namespace symplant::read {

/// All of these rules, by id.
std::span<const diag::RuleInfo* const> rules();

}  // namespace symplant::read
