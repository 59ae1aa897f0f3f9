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
letters. This one fits none of the plant's devices.

**What the model loses.** What stands under it counts for nobody.

**How to mend it.** Mind the levels: the devices of a line are `EXLINE_*`, a kind of device in any line and process `*_STOPPER?`.
Or delete the entry, where the devices are gone from the list.
)page"};

}  // namespace symplant::description
