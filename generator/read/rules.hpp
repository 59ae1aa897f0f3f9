// The rules of reading.
#pragma once

#include <span>

#include "diag/diagnostic.hpp"

namespace symplant::read {

/// By id.
std::span<const diag::RuleInfo* const> rules();

}  // namespace symplant::read
