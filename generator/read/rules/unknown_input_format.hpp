// SP106: the option `--input-format` names an unknown format.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUnknownInputFormat{
    .id = "SP106",
    .slug = "unknown-input-format",
    .severity = diag::Severity::error,
    .summary = "--input-format names an unknown format",
    .page =
        R"page(The word after `--input-format` is not a known format of a list. The message names the known formats in lower case.

**What the model loses.** It cannot be built: the list is not even opened, and nothing is written.

**How to fix it.** Write one of the names in the message, or omit the option: the format is then recognized by
the content of the file.
)page"};

}  // namespace symplant::read
