// SP605: some devices lack what is said of them under a pattern.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kLeftOutForSome{
    .id = "SP605",
    .slug = "left-out-for-some",
    .severity = diag::Severity::warning,
    .summary = "some devices lack what is said of them under a pattern",
    .page =
        R"page(An entry under a pattern names a state, an operation or an event that some of the devices have and others lack. For those
it is left out: the others have it.

**What the model loses.** Nothing where that was meant. Where those devices ought to have it, a symbol is missing in the list,
or its name has a slip.

**How to mend it.** Make the pattern fit only the devices that are meant, or say it under their own names.
)page"};

}  // namespace symplant::description
