// SP607: a plant description says what cannot be.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kDescriptionContradiction{
    .id = "SP607",
    .slug = "description-contradiction",
    .severity = diag::Severity::error,
    .summary = "a plant description says what cannot be",
    .page =
        R"page(Each name is known, but together they make no sense: a transition of a state to itself, the same transition twice, an
`automatic` one with an operation, a `rest` state where nothing springs back, a state added that a symbol names already, a
device that disables itself, a device or a requirement that is described twice.

**What the model loses.** It cannot be built, since one half of what is said would have to be passed over.

**How to mend it.** The message says what to leave out or to add.
)page"};

}  // namespace symplant::description
