// SP602: a plant description names an unknown device, state, operation or event.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kDescriptionUnknownName{
    .id = "SP602",
    .slug = "description-unknown-name",
    .severity = diag::Severity::error,
    .summary = "a plant description names an unknown device, state, operation or event",
    .page =
        R"page(Names in `plant.json` are those of the symbol lists, without regard to case: a device is LINE_PROC_DEV, a state
and an operation are the last level of a symbol's name. Tracks, places and kinds of parts are keys of `material`. Entries of `times` name transitions that the device has.
The message proposes the nearest known name. An entry under a pattern (`EXLINE_*`) is reported only if every device that
takes it lacks the name.

**What the model loses.** It cannot be built: a transition to a state that the device lacks would never be taken, without
notice.

**How to fix it.** Write the name as the list has it; `symplant model PLANT --device NAME` shows a device's states. A state
that no symbol names is added with `"states"`.
)page"};

}  // namespace symplant::description
