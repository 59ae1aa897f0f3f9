// SP122: a list does not have the part that was asked for.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kNoSuchPart{
    .id = "SP122",
    .slug = "no-such-part",
    .severity = diag::Severity::error,
    .summary = "a text does not hold as many lists as asked for",
    .page =
        R"page(A list of plant.json has a `"part"`, which selects one of several lists in one text. The text holds fewer. Another list begins where
the header occurs again, or where the addresses start over: most of the next rows have I/O addresses that rows before them have.

**What the model loses.** It cannot be built, and nothing is written.

**How to fix it.** Use a number from 1 to that of the message, or omit `"part"` to read all rows.
)page"};

}  // namespace symplant::read
