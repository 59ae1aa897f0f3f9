// SP103: a list is empty or holds only blanks.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kEmptyFile{
    .id = "SP103",
    .slug = "empty-file",
    .severity = diag::Severity::error,
    .summary = "a list is empty",
    .page =
        R"page(The file is empty, or holds only blanks and line ends. Most often an export was interrupted.

**What the model loses.** It cannot be built: without symbols there is no plant. Nothing is written.

**How to fix it.** Export the list again, and check the size of the file.
)page"};

}  // namespace symplant::read
