// SP605: some devices lack a name that a pattern's entry uses.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kLeftOutForSome{
    .id = "SP605",
    .slug = "left-out-for-some",
    .severity = diag::Severity::warning,
    .summary = "some devices lack a name that a pattern's entry uses",
    .page =
        R"page(An entry under a pattern names a state, an operation or an event that some of the devices have and others lack, or a name
with braces (`{line}_DOOR.OPEN`) that the plant has for some of the devices only. It is left out for the others.

**What the model loses.** Nothing if that is intended. If those devices should have it, a symbol is missing in the list, or
its name has a slip.

**How to fix it.** Make the pattern match only the intended devices, or describe these under their names.
)page"};

}  // namespace symplant::description
