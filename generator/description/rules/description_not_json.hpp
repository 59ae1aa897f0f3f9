// SP600: a plant description is not JSON.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kDescriptionNotJson{
    .id = "SP600",
    .slug = "description-not-json",
    .severity = diag::Severity::error,
    .summary = "a plant description is not JSON",
    .page =
        R"page(A `plant.json` is JSON, with comments (`// ...` and `/* ... */`) allowed. This one is incomplete, has a comma too
many or too few, or holds something else that is not JSON; or an object in it has a key twice, so that one of the two
values would be ignored. Then both locations are shown.

**What the model loses.** It cannot be built, and nothing is written.

**How to fix it.** Look at the location shown and just before it: a comma after the last entry of an object or array, a
missing comma between two entries, a text without its closing `"`. If a key appears twice, merge both values. An editor
that uses the schema (`symplant schema plant`) shows such faults while you type.
)page"};

}  // namespace symplant::description
