// SP104: a list has a header but no row that declares a symbol.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kHeaderAlone{
    .id = "SP104",
    .slug = "header-alone",
    .severity = diag::Severity::error,
    .summary = "a list has a header and no symbol",
    .page = R"page(The list's header was recognised, but no row below it declares a symbol: there is none, or every one
was left out because it has no identifier (SP109 tells which).

**What the model loses**: all of it: there is no symbol, so there is no plant; nothing is written.

**How to mend it**: export the list again with its rows; some tools export only the selected rows, or only
those with an address.
)page"};

}  // namespace symplant::read
