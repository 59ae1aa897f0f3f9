// SP110: more text follows between the closing quote of a cell and the next delimiter.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kTextAfterQuote{
    .id = "SP110",
    .slug = "text-after-quote",
    .severity = diag::Severity::warning,
    .summary = "text follows the closing quote of a cell",
    .page =
        R"page(A quoted cell ends at the next `"` that is not doubled, and only blanks may follow before the delimiter. Here more
text follows. Most often a quote within the cell was not doubled: `"the 5" valve"`.

**What the model loses.** The text after the quote is left out, so a comment or a name is shorter than intended.
If that text contains a delimiter, it ends there, and the cells after it are shifted.

**How to fix it.** Write a quote within a quoted cell twice: `"the 5"" valve"`.
)page"};

}  // namespace symplant::read
