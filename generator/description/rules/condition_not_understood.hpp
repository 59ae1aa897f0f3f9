// SP606: a text is not a condition of this plant.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kConditionNotUnderstood{
    .id = "SP606",
    .slug = "condition-not-understood",
    .severity = diag::Severity::error,
    .summary = "a text is not a condition of this plant",
    .page =
        R"page(A condition is `DEVICE.STATE`, `DEVICE.moving`, a BOOL symbol, or a numeric symbol compared with a number (`< <= = >= >`), joined
by `not`, `and`, `or` (binding in this order) and brackets. Here the text is incomplete or malformed, or it names an unknown
device, state or symbol; the message shows the location in the text and the nearest name.

**What the model loses.** It cannot be built.

**How to fix it.** Write names as the list has them. Put a name that is not an identifier (blanks, `-`) in single quotes:
`'S441-2 V1'.OPEN`.
)page"};

}  // namespace symplant::description
