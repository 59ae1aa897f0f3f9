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
        R"page(The file is JSON, but it does not have the shape of a `plant.json`: an unknown key (the message names the nearest known
one), a text in place of a number, a missing key, an invalid duration; or it is another kind of file, or uses a version
of the format that this symplant does not read. Or it includes a file that cannot be read, or that includes itself.

**What the model loses.** It cannot be built, and nothing is written: symplant never ignores what it does not understand,
because then a typing mistake would silently change the plant.

**How to fix it.** The message names the actual and the expected value. The whole format is in the manual's page on
plant.json and in the schema, `symplant schema plant`.
)page"};

}  // namespace symplant::description
