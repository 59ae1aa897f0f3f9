// SP601: a plant description does not fit its format.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::description {

inline constexpr diag::RuleInfo kDescriptionSchema{
    .id = "SP601",
    .slug = "description-schema",
    .severity = diag::Severity::error,
    .summary = "a plant description does not fit its format",
    .page =
        R"page(The file is JSON, but not of the shape that a `plant.json` has: a key that is unknown there (the nearest known one is
told), a text where a number belongs, a missing key, a text that is no duration; or it is another kind of file
altogether, or one of a version of the format that this symplant does not read.

**What the model loses.** It cannot be built, and nothing is written: what is not understood is never passed over, or a
slip of the keyboard would silently change the plant.

**How to mend it.** The message says what is there and what is wanted. The whole format is in the manual's page on
plant.json and in the schema, `symplant schema plant`.
)page"};

}  // namespace symplant::description
