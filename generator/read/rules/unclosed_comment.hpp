// SP114: a comment in Structured Text is not closed before the end of the file.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUnclosedComment{
    .id = "SP114",
    .slug = "unclosed-comment",
    .severity = diag::Severity::warning,
    .summary = "a comment in Structured Text is never closed",
    .page =
        R"page(A comment that begins with `(*` or `/*` goes on, over line ends too, up to `*)` or `*/`. Comments with `(*` may contain
others. Here the end of the file comes first. If a `*)` follows, the comment is taken to end there, as in tools without
nested comments; without one it goes on to the end of the file.

**What the model loses.** All declarations after the begin of the comment, if nothing closes it. If a `*)` was found, the
declarations after it are read, which may have been meant as a part of the comment.

**How to fix it.** Close the comment, or remove its beginning.
)page",
    .rank = diag::Rank::row};

}  // namespace symplant::read
