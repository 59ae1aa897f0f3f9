// SP106: the option `--input-format` names no format that is known.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUnknownInputFormat{
    .id = "SP106",
    .slug = "unknown-input-format",
    .severity = diag::Severity::error,
    .summary = "--input-format names no known format",
    .page =
        R"page(The word after `--input-format` is no format of a list that can be read. The message names those that are; they are
written in lower case.

**What the model loses.** It cannot be built: the list is not even opened, and nothing is written.

**How to mend it.** Write one of the names in the message, or leave the option out: the format is then told by what
stands in the file.
)page"};

}  // namespace symplant::read
