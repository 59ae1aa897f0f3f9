// SP120: two columns of a table serve equally well as identifiers or addresses.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kAmbiguousColumns{
    .id = "SP120",
    .slug = "ambiguous-columns",
    .severity = diag::Severity::error,
    .summary = "two columns of a table serve equally well as identifiers or addresses",
    .page =
        R"page(A table of an unknown tool has two columns that could hold the identifiers, or two that could hold the addresses, and neither
the header nor the cells decide: for example, they are `Tag` and `Symbol`, and no cell occurs twice. The message shows both with
their first cells.

**What the model loses.** It cannot be built: the wrong column would give a plant with the wrong names. Nothing is written.

**How to fix it.** Name the column: `--columns name=Tag,address=3`, or in plant.json
`{ "file": "list.csv", "columns": { "name": "Tag", "address": 3 } }`. A column is given by its header or by its number, counted
from 1.
)page"};

}  // namespace symplant::read
