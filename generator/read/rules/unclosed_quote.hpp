// SP108: the quote that opens a cell is not closed before the end of the file.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUnclosedQuote{
    .id = "SP108",
    .slug = "unclosed-quote",
    .severity = diag::Severity::error,
    .summary = "a quoted cell is never closed",
    .page =
        R"page(A cell that begins with `"` goes on, over line ends too, up to the next `"` that is not doubled. Here no such quote follows: the
cell would swallow the rest of the list. The location is that of the opening quote. The mistake itself may be further
up: one quote too many turns every opening quote after it into a closing one. SP110 then often shows the row.

**What the model loses.** It cannot be built: it is not known which rows are meant. Nothing is written.

**How to fix it.** Close the quote, or remove it. A quote within a quoted cell is written twice: `"the 5"" valve"`.
)page"};

}  // namespace symplant::read
