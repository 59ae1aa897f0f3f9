// SP107: the header of a list has no column of identifiers.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kMissingColumn{
    .id = "SP107",
    .slug = "missing-column",
    .severity = diag::Severity::error,
    .summary = "a list has no column of identifiers",
    .page =
        R"page(The header was recognised by other columns (class, address, type ...), but none of them holds the names
of the symbols. The name is what the model is derived from: nothing can stand for it.

**What the model loses**: everything that stands in the file; nothing is written.

**How to mend it**: export the list with its identifiers, or rename their column. `Identifier`,
`Label Name`, `Variable` and `Name` are understood, whatever their case.
)page"};

}  // namespace symplant::read
