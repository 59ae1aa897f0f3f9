// SP104: a list has a header but no row that declares a symbol.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kHeaderAlone{
    .id = "SP104",
    .slug = "header-alone",
    .severity = diag::Severity::error,
    .summary = "a list has a header but no symbol",
    .page =
        R"page(The columns of the list are known, but no row gives a symbol: below the header there is no row, or every row
was left out because it has no identifier (SP109 names those).

**What the model loses.** It cannot be built: without symbols there is no plant. Nothing is written.

**How to fix it.** Export the list again with its rows. If SP109 names rows, give them identifiers.
)page"};

}  // namespace symplant::read
