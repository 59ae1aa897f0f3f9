// SP101: a file could not be read at all.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kCannotReadFile{
    .id = "SP101",
    .slug = "cannot-read-file",
    .severity = diag::Severity::error,
    .summary = "a file cannot be read",
    .page =
        R"page(The list that was named cannot be opened or read: it does not exist, it is a folder, its permissions forbid it, or the
disk failed. The message gives the reason.

**What the model loses.** It cannot be built: no row is known, and nothing is written.

**How to mend it.** Correct the path, which counts from the folder that the tool was started in, or the permissions
(`ls -l`). Give the list itself, not the folder that it lies in.
)page"};

}  // namespace symplant::read
