// SP116: a row of a list does not have the form of its format.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kRowNotUnderstood{
    .id = "SP116",
    .slug = "row-not-understood",
    .severity = diag::Severity::warning,
    .summary = "a row does not have the form of the list's format",
    .page =
        R"page(The list has a known format, but this row has another form: a cell is missing, a quote or a bracket is not closed,
or the line is cut. Lists that were edited by hand, joined from several exports or damaged in transfer have such rows.

**What the model loses.** The row is left out: it gives no symbol, and its address is not served unless another row has
the same address.

**How to fix it.** Export the list again. If it was edited, compare the row with the one above it.
)page",
    .rank = diag::Rank::row};

}  // namespace symplant::read
