// SP104: a list has a header but no row that declares a symbol.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kHeaderAlone{
    .id = "SP104",
    .slug = "header-alone",
    .severity = diag::Severity::error,
    .summary = "a list has a header and no symbol",
    .page =
        R"page(The columns of the list are known, but no row gives a symbol: below the header there is no row, or each was left out
because it has no identifier (SP109 names those).

**What the model loses.** It cannot be built: without symbols there is no plant. Nothing is written.

**How to mend it.** Export the list again with its rows. If SP109 names rows, give these their identifiers.
)page"};

}  // namespace symplant::read
