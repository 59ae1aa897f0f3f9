// SP603: two equally specific patterns give a key of a device different values.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kContradictoryPatterns{
    .id = "SP603",
    .slug = "contradictory-patterns",
    .severity = diag::Severity::error,
    .summary = "two equally specific patterns give a key of a device different values",
    .page =
        R"page(Several entries of `"devices"` (or of `"times"`) may match one device. Key by key an exact name beats every pattern, and of patterns
the one with more literal characters wins. Here two patterns with equally many give one key different values, and neither an exact
name nor a more specific pattern decides.

**What the model loses.** It cannot be built: symplant does not guess which of the two is meant.

**How to fix it.** Make one of the patterns longer, or set the key under the device's exact name; or give both the same value.
)page"};

}  // namespace symplant::description
