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
        R"page(A header was found by at least three of its columns (class, addresses, type ...), but none of its columns is a column of
identifiers. A device and its states are read from the names of its symbols, so nothing can replace them.

**What the model loses.** It cannot be built, and nothing is written.

**How to fix it.** Export the list with its identifiers, or name their column `Identifier`, `Label Name`, `Variable` or
`Name`, in whatever case.
)page"};

}  // namespace symplant::read
