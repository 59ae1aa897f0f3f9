// SP101: a file could not be read.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kCannotReadFile{
    .id = "SP101",
    .slug = "cannot-read-file",
    .severity = diag::Severity::error,
    .summary = "a file cannot be read",
    .page =
        R"page(The named list cannot be opened or read: it does not exist, it is a folder, its permissions forbid it, or the
disk failed. The message gives the reason.

**What the model loses.** It cannot be built: no row is known, and nothing is written.

**How to fix it.** Correct the path, which is relative to the folder in which the tool was started, or the permissions
(`ls -l`). Give the list itself, not its folder.
)page"};

}  // namespace symplant::read
