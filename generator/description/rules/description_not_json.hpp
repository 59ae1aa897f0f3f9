// SP600: a plant description is no JSON.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kDescriptionNotJson{
    .id = "SP600",
    .slug = "description-not-json",
    .severity = diag::Severity::error,
    .summary = "a plant description is no JSON",
    .page =
        R"page(A `plant.json` is JSON, with comments (`// ...` and `/* ... */`) allowed. This one breaks off, has a comma too many or too
few, or something else that JSON does not have; or an object in it has one key twice, which would make one of the two
count and the other be forgotten. Both places are shown then.

**What the model loses.** It cannot be built, and nothing is written.

**How to mend it.** Look at the place shown and just before it: a comma behind the last entry of an object or array, a
missing comma between two, a text without its closing `"`. Of a key that stands twice, join both values in one. An editor
that knows the schema (`symplant schema plant`) shows such faults while you type.
)page"};

}  // namespace symplant::description
