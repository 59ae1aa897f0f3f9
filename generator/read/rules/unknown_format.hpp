// SP105: a file is text, but not a known symbol list.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUnknownFormat{
    .id = "SP105",
    .slug = "unknown-format",
    .severity = diag::Severity::error,
    .summary = "a file is not a known symbol list",
    .page =
        R"page(The first 64 rows do not show what the columns mean. There is no header that names a column of identifiers and
one of classes, addresses or types (`Name` and `Type` alone could be any table's), and no row with a class such as
`VAR_GLOBAL` and another cell with content.

**What the model loses.** It cannot be built, and nothing is written.

**How to fix it.** Export the global variables as text, separated by comma, semicolon or TAB. Or put a header above the
rows, with the names in the order of the columns: `Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment`.
`Identifier` and one of `Class`, `MIT-Addr.`, `IEC-Addr.` and `Type` are required, the others are optional.
)page"};

}  // namespace symplant::read
