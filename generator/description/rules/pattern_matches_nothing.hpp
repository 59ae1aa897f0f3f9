// SP604: a pattern matches no device.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kPatternMatchesNothing{
    .id = "SP604",
    .slug = "pattern-matches-nothing",
    .severity = diag::Severity::warning,
    .summary = "a pattern matches no device",
    .page =
        R"page(A pattern (`*` is any text, `?` one character) is compared with the whole of LINE_PROC_DEV, without regard to the case of
letters. This one matches no device of the plant.

**What the model loses.** The entry applies to no device.

**How to fix it.** Check the levels: the devices of a line are `EXLINE_*`, a kind of device in any line and process `*_STOPPER?`.
If the devices are no longer in the list, delete the entry.
)page"};

}  // namespace symplant::description
