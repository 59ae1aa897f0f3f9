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
        R"page(A cell that begins with `"` ends at the next single `"`. Here there is none, so the cell would swallow the
rest of the list. The place is where the quote opens; where several cells are at fault, the fault that
begins it all may stand further up (see SP110).

**What the model loses**: nothing is read and nothing is written, since which rows are meant is not known.

**How to mend it**: close the quote, or take it out. A quote inside a quoted cell is written twice:
`"the 5"" valve"`.
)page"};

}  // namespace symplant::read
