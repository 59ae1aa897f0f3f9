// SP103: a list holds nothing but blanks.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kEmptyFile{
    .id = "SP103",
    .slug = "empty-file",
    .severity = diag::Severity::error,
    .summary = "a list is empty",
    .page = R"page(The file is empty, or holds only blanks and line ends. Mostly an export was broken off, or the list
was exported without having been opened in the engineering tool.

**What the model loses**: all of it: there is no symbol, so there is no plant; nothing is written.

**How to mend it**: export the list again and look at its size.
)page"};

}  // namespace symplant::read
