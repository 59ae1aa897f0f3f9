// SP606: a text is no condition of this plant.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kConditionNotUnderstood{
    .id = "SP606",
    .slug = "condition-not-understood",
    .severity = diag::Severity::error,
    .summary = "a text is no condition of this plant",
    .page =
        R"page(A condition is `DEVICE.STATE`, `DEVICE.moving`, a BOOL symbol, or a numeric symbol compared with a number (`< <= = >= >`), joined
by `not`, `and`, `or` (binding in this order) and brackets. Here the text breaks off, or it names a device, a state or a symbol
that there is not; the place in the text is shown, and the nearest name.

**What the model loses.** It cannot be built.

**How to mend it.** Write names as the list has them. A name that is no identifier (blanks, `-`) stands in single quotes:
`'S441-2 V1'.OPEN`.
)page"};

}  // namespace symplant::description
