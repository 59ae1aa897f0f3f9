// SP103: a list holds nothing but blanks.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kEmptyFile{
    .id = "SP103",
    .slug = "empty-file",
    .severity = diag::Severity::error,
    .summary = "a list is empty",
    .page =
        R"page(The file is empty, or holds only blanks and line ends. Most often an export was broken off.

**What the model loses.** It cannot be built: without symbols there is no plant. Nothing is written.

**How to mend it.** Export the list again, and look at its size before it is used.
)page"};

}  // namespace symplant::read
