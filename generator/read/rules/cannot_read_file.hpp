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
        R"page(The file that was named could not be opened or read: it is missing, it is a directory, its permissions
forbid it, or the disk failed. The message gives the reason.

**What the model loses**: everything that stands in the file; nothing is written.

**How to mend it**: check the path (it counts from the folder the tool was started in, or, inside a
description, from the description's folder) and the permissions (`ls -l`). Give the list itself, not the
folder it lies in.
)page"};

}  // namespace symplant::read
