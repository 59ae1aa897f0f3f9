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
        R"page(The row's cell in the column of identifiers is empty while others are not. Titles, footers and separating
lines between the rows look like this, and so does an address that was reserved but not named.

**What the model loses**: the row is left out: no symbol is made of it, and its address is served by nobody.

**How to mend it**: name the symbol, or take the row out of the list. Where many rows are reported, look at
`--verbose`: perhaps the column of identifiers is another one than was taken.
)page"};

}  // namespace symplant::read
