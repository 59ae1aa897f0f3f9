// SP602: a plant description names a device, state, operation or event that there is not.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kDescriptionUnknownName{
    .id = "SP602",
    .slug = "description-unknown-name",
    .severity = diag::Severity::error,
    .summary = "a plant description names a device, state, operation or event that there is not",
    .page =
        R"page(Names in `plant.json` are those of the symbol lists, whatever the case of their letters: a device is LINE_PROC_DEV, a state
and an operation are the last level of a symbol's name. The message tells the nearest name that there is. Of what stands
under a pattern (`EXLINE_*`), an entry is told only where every device that takes it lacks what it names.

**What the model loses.** It cannot be built: a transition to a state that the device lacks would never be taken, and nobody
would notice.

**How to mend it.** Write the name as the list has it; `symplant model PLANT --device NAME` shows a device's states. A state
that no symbol names is added with `"states"`.
)page"};

}  // namespace symplant::description
