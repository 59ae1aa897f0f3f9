// SP102: the bytes of a file are no text that can be read.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUndecodableText{
    .id = "SP102",
    .slug = "undecodable-text",
    .severity = diag::Severity::error,
    .summary = "a file is no text in a known encoding",
    .page = R"page(The file is neither UTF-8 nor UTF-16, or it holds characters that no text has (NUL, many control
characters). The place is the first byte that does not fit.

Two causes are common. The list is in the code page of the machine it was exported on (Western, Korean,
Japanese ...): such a file is refused and not guessed at, since a wrong guess would quietly spoil names.
Or the file is no text at all: a workbook, a project file, an archive.

**What the model loses**: everything that stands in the file; nothing is written.

**How to mend it**: export the list as Unicode text, or open it in an editor and save it as UTF-8. Where
UTF-16 without a byte order mark was not recognised, say so with `--encoding utf-16le` or `utf-16be`.
)page"};

}  // namespace symplant::read
