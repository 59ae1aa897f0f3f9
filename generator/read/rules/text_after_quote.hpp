// SP110: between the closing quote of a cell and the next delimiter stands more text.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kTextAfterQuote{
    .id = "SP110",
    .slug = "text-after-quote",
    .severity = diag::Severity::warning,
    .summary = "text follows the closing quote of a cell",
    .page =
        R"page(A quoted cell ends at the next single `"`; only blanks may follow before the delimiter. Mostly a quote
inside the cell was not doubled (`"the 5" valve"`), which some tools export so. It may also be that a quote
further up was never closed and this is the beginning of another cell.

**What the model loses**: the text after the quote is left out; the cell is what stands between the quotes.
Where a name or an address is cut so, the symbol is another one than meant.

**How to mend it**: write a quote inside a quoted cell twice: `"the 5"" valve"`.
)page"};

}  // namespace symplant::read
