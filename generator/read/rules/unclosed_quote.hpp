// SP108: a quote opens a cell and nothing closes it up to the end of the file.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUnclosedQuote{
    .id = "SP108",
    .slug = "unclosed-quote",
    .severity = diag::Severity::error,
    .summary = "a quoted cell is never closed",
    .page =
        R"page(A cell that begins with `"` goes on, over line ends too, up to the next `"` that is not doubled. Here there is none: the
cell would swallow the rest of the list. The place is where its quote opens. The fault itself may stand further up,
where a quote too many made all that follow change sides; SP110 then often shows the row.

**What the model loses.** It cannot be built: it is not known which rows are meant. Nothing is written.

**How to mend it.** Close the quote, or take it away. A quote within a quoted cell is written twice: `"the 5"" valve"`.
)page"};

}  // namespace symplant::read
