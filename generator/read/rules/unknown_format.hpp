// SP105: a file is text, but no symbol list that is known.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUnknownFormat{
    .id = "SP105",
    .slug = "unknown-format",
    .severity = diag::Severity::error,
    .summary = "a file is no known symbol list",
    .page =
        R"page(Among the first rows there is neither a header that names a column of identifiers and one of class, type
or address, nor a cell with a class such as `VAR_GLOBAL`. So it is not known what the columns mean.

**What the model loses**: everything that stands in the file; nothing is written.

**How to mend it**: export the global variables as delimited text (comma, semicolon or TAB), or put a header
above the rows:

    Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment

Only `Identifier` and one of the others are needed, in any order.
)page"};

}  // namespace symplant::read
