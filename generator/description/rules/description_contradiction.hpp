// SP607: a plant description contradicts itself or the symbol list.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kDescriptionContradiction{
    .id = "SP607",
    .slug = "description-contradiction",
    .severity = diag::Severity::error,
    .summary = "a plant description contradicts itself or the symbol list",
    .page =
        R"page(Each name is known, but the entries contradict each other: a transition of a state to itself, the same transition
twice, an `automatic` one with an operation, a `rest` state without a spring, an added state that a symbol already
names, a device that disables itself, a device or a requirement that is described twice, a position beyond the end of
its track, a symbol with two sensors.

**What the model loses.** It cannot be built, because a part of the description would have to be ignored.

**How to fix it.** The message says what to remove or to add.
)page"};

}  // namespace symplant::description
