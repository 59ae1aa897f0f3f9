// SP124: a file is of a known kind that is not read.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kRecognizedFormat{
    .id = "SP124",
    .slug = "recognized-format",
    .severity = diag::Severity::error,
    .summary = "a file has a known format that symplant does not read",
    .page =
        R"page(The content shows what the file is: the project of an engineering tool, a picture, an archive, a description of a device, a
program. It is not a list of symbols, or not one that symplant reads. The message names it, and the export of the same tool
that is read.

**What the model loses.** It cannot be built, and nothing is written.

**How to fix it.** Make the export that the message names. The page on formats (`docs/formats.md`) shows the steps for each tool.
)page"};

}  // namespace symplant::read
