// SP608: a naming rule does not fit its format.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::naming {

inline constexpr diag::RuleInfo kNamingSchema{
    .id = "SP608",
    .slug = "naming-schema",
    .severity = diag::Severity::error,
    .summary = "a naming rule does not fit its format",
    .page =
        R"page(The file given by `--naming` or by the key `naming` of `plant.json`, or the rule written there, does not have the
shape of a naming rule: it is not JSON, a key is unknown or missing, a text is given in place of a number, a duration is invalid, or the
file uses a version of the format that this symplant does not read. The same rule reports a `links` file that is not
a CSV table with the columns `operation`, `event` and `state`.

**What the model loses.** It cannot be built, and nothing is written: without its naming rule the list would give another
plant.

**How to fix it.** The message names the actual and the expected value, and for an unknown key the nearest known one. The
whole format is in the manual's page on naming rules and in the schema, `symplant schema naming`.
)page"};

}  // namespace symplant::naming
