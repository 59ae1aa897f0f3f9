// SP109: a row of a list has content, but no identifier.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kRowWithoutIdentifier{
    .id = "SP109",
    .slug = "row-without-identifier",
    .severity = diag::Severity::warning,
    .summary = "a row has no identifier",
    .page =
        R"page(A row has something in its cells, but nothing in the column of identifiers. Titles, footers and page numbers between the
rows look like this, and so does an address that was reserved and never named.

**What the model loses.** The row is left out: it gives no symbol, and its address is not served unless another row has
the same address.

**How to fix it.** Name the symbol, or delete the row. If many rows are reported, check with `--verbose` which column
was taken for the identifiers.
)page"};

}  // namespace symplant::read
