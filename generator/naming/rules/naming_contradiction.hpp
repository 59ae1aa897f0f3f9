// SP609: a naming rule cannot be used.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::naming {

inline constexpr diag::RuleInfo kNamingContradiction{
    .id = "SP609",
    .slug = "naming-contradiction",
    .severity = diag::Severity::error,
    .summary = "a naming rule contradicts itself, has an invalid pattern, or names something unknown",
    .page =
        R"page(The naming rule fits its format, but it cannot be used: a pattern or a regular expression is invalid, a pattern has an
unknown field, `fields` describes a field that the pattern lacks, an archetype lacks a role that its model needs or has
one that its model does not know, a key has no effect next to another one, or a ready profile does not exist.

**What the model loses.** It cannot be built, because a part of the naming rule would have to be ignored.

**How to fix it.** The message says what to remove or to add, and names the nearest known name. `symplant naming` lists the
ready profiles; `symplant naming NAME` prints one to begin with.
)page"};

}  // namespace symplant::naming
