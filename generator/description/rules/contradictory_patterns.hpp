// SP603: two equally specific patterns say different things of a device.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kContradictoryPatterns{
    .id = "SP603",
    .slug = "contradictory-patterns",
    .severity = diag::Severity::error,
    .summary = "two equally specific patterns say different things of a device",
    .page =
        R"page(Several entries of `"devices"` may speak of one device. Key by key an exact name beats every pattern, and of patterns the one
with more literal characters wins. Here two patterns with equally many give one key different values, and neither an exact
name nor a more specific pattern decides.

**What the model loses.** It cannot be built: which of the two is meant is not to be guessed.

**How to mend it.** Make one of the patterns longer, or say it once more under the device's own name; or let both say the same.
)page"};

}  // namespace symplant::description
